# shellcheck shell=bash
# Sourced by ./run and ./test. What needs no Python is decided here, the rest in bootstrap/*.py.

: "${checkout:?the root folder of the checkout, set by who sources this}"

say() {
    printf 'rqt_mrta_py: %s\n' "$*" >&2
}

# Make .venv, ROS and the messages ready for a level (run or test), and enter that environment.
bootstrap() {
    local level=$1
    export PYTHONNOUSERSITE=1
    source_ros /opt/ros
    stamp_is_valid "$level" || set_up "$level"
    export PATH="$checkout/.venv/bin:$PATH"
    case ":${ROS_PACKAGE_PATH:-}:" in
        *":$checkout:$checkout/plugins:"*) ;;
        *) export ROS_PACKAGE_PATH="${ROS_PACKAGE_PATH:+$ROS_PACKAGE_PATH:}$checkout:$checkout/plugins" ;;
    esac
}

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
    # ROS's own scripts read unset variables and let commands fail.
    set +eu
    # shellcheck disable=SC1090
    source "$chosen" >&2
    set -eu
}

stamp_is_valid() {
    "$checkout/.venv/bin/python" -I -S -B "$checkout/bootstrap" check "$1" 2>/dev/null
}

# Bring the checkout up to a level, one process at a time.
set_up() {
    local level=$1 python
    exec 9>>"$checkout/.bootstrap.lock"
    if ! flock --nonblock 9; then
        say "another set-up of this checkout is under way; waiting for it"
        flock 9
    fi
    if ! stamp_is_valid "$level"; then
        python=$(find_python /usr/bin/python3) || python=$(install_python) || exit 4
        "$python" -I -B "$checkout/bootstrap" "$level" >&2 || exit
    fi
    exec 9>&-
}

# Print the interpreter to build on: the system's, else python3 from PATH; a version manager's shim comes last, resolved.
find_python() {
    local system=$1 folder
    local -a folders candidates=("$system") shims=()
    IFS=: read -ra folders <<<"$PATH"
    for folder in "${folders[@]}"; do
        case $folder/ in
            "$checkout"/.venv/*) ;;
            */shims/*) shims+=("$folder/python3") ;;
            *) candidates+=("$folder/python3") ;;
        esac
    done
    for candidate in "${candidates[@]}" "${shims[@]}"; do
        [[ -x $candidate ]] || continue
        "$candidate" -I -c 'import sys; sys.version_info < (3, 8) and sys.exit(1); print(sys.executable)' 2>/dev/null && return
    done
    return 1
}

# Install Python by apt where allowed, and print it.
install_python() {
    local -a as_root=()
    ((EUID == 0)) || as_root=(sudo -n)
    if [[ ${MRTA_NO_APT:-0} == 0 ]] && command -v apt-get >/dev/null && "${as_root[@]}" true 2>/dev/null; then
        say "installing with ${as_root[*]:+${as_root[*]} }apt-get: python3 python3-venv"
        "${as_root[@]}" apt-get -qq update >&2 || true
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
            -o DPkg::Lock::Timeout=600 install python3 python3-venv >/dev/null || true
        find_python /usr/bin/python3 && return
    fi
    say "no Python from 3.8 on was found; install the packages python3 and python3-venv"
    return 4
}
