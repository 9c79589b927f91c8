# shellcheck shell=bash
# ROS 1 under /opt/ros, and the checkout's place among its packages.

: "${checkout:?}"

# Source ROS 1 below a folder such as /opt/ros: the user's ROS_DISTRO, else the last by name.
# A workspace that already builds on it stays as it is, for setup.bash would drop the user's overlay.
source_ros() {
    local folder=$1 candidate chosen=
    case ":${CMAKE_PREFIX_PATH:-}:" in *":$folder/"*) return ;; esac
    for candidate in "$folder"/*/setup.bash; do
        [[ -e $candidate ]] || continue
        [[ ! -e ${candidate%/*}/share/ament_index ]] || continue # ROS 2
        chosen=$candidate
        [[ ${candidate%/*} != "$folder/${ROS_DISTRO:-}" ]] || break
    done
    [[ -n $chosen ]] || return 0
    # ROS's own scripts read unset variables, let commands fail and look at their arguments.
    set +eu
    set --
    # shellcheck disable=SC1090
    source "$chosen" >&2
    set -eu
}

# Let ROS tools find the main package and those under plugins/, after whatever the user put on the path.
append_to_ros_path() {
    case ":${ROS_PACKAGE_PATH:-}:" in
        *":$checkout:$checkout/plugins:"*) ;;
        *) export ROS_PACKAGE_PATH="${ROS_PACKAGE_PATH:+$ROS_PACKAGE_PATH:}$checkout:$checkout/plugins" ;;
    esac
}
