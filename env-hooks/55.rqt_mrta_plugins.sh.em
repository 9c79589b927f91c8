@[if DEVELSPACE]@
# Appended, so that a user's own package of the same name goes first.
case ":${ROS_PACKAGE_PATH}:" in
  *":@(CMAKE_CURRENT_SOURCE_DIR)/plugins:"*) ;;
  *) export ROS_PACKAGE_PATH="${ROS_PACKAGE_PATH:+$ROS_PACKAGE_PATH:}@(CMAKE_CURRENT_SOURCE_DIR)/plugins" ;;
esac
@[end if]@
