# shellcheck shell=bash
# Sourced by ./run and ./test. What needs no Python is decided here and in the files below, the rest in bootstrap/*.py.

: "${checkout:?the root folder of the checkout, set by who sources this}"
# shellcheck source=bootstrap/interpreter.sh
source "$checkout/bootstrap/interpreter.sh"
# shellcheck source=bootstrap/ros.sh
source "$checkout/bootstrap/ros.sh"
# shellcheck source=bootstrap/stamp.sh
source "$checkout/bootstrap/stamp.sh"

say() {
    printf 'rqt_mrta_py: %s\n' "$*" >&2
}

# Tell whether the user left MRTA_NO_APT unset, empty or 0.
apt_is_allowed() {
    [[ ${MRTA_NO_APT:-0} == 0 ]]
}

# Make .venv, ROS and the messages ready for a level (run or test), and enter that environment.
bootstrap() {
    local level=$1
    export PYTHONNOUSERSITE=1
    source_ros /opt/ros
    [[ $(what_to_do "$level") == nothing ]] || set_up "$level"
    export PATH="$checkout/.venv/bin:$PATH"
    append_to_ros_path
}

# Bring the checkout up to a level, one process at a time.
set_up() {
    local level=$1 todo python apt
    exec 9>>"$checkout/.bootstrap.lock"
    if ! flock --nonblock 9; then
        say "another set-up of this checkout is under way; waiting for it"
        flock 9
    fi
    todo=$(what_to_do "$level")
    if [[ $todo != nothing ]]; then
        python=$(find_python /usr/bin/python3) || python=$(install_python) || exit
        read_stamp
        look_around
        # What was made ready for the tests stays so.
        [[ ${stamped[level]:-} != test ]] || level="test"
        rm -f -- "$stamp"
        apt=$("$python" -I -B "$checkout/bootstrap" "$level" "$todo") || exit
        write_stamp "$level" "${apt:-${stamped[apt]}}"
        say "ready: $checkout/.venv on $python"
    fi
    exec 9>&-
}
