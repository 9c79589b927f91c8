# Appended, so that a user's own package of the same name goes first.
@[if DEVELSPACE]@
_rqt_mrta_folder="@(CMAKE_CURRENT_SOURCE_DIR)/plugins"
@[else]@
_rqt_mrta_folder="$CATKIN_ENV_HOOK_WORKSPACE/share/rqt_mrta_py/stubs"
@[end if]@
case ":${ROS_PACKAGE_PATH}:" in
  *":${_rqt_mrta_folder}:"*) ;;
  *) export ROS_PACKAGE_PATH="${ROS_PACKAGE_PATH:+$ROS_PACKAGE_PATH:}${_rqt_mrta_folder}" ;;
esac
unset _rqt_mrta_folder
