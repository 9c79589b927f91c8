# shellcheck shell=bash
# The stamp that a finished set-up leaves in .venv: lines "name value" with all that it was made from.
#
#   level        what it serves, run or test; the second includes the first
#   apt          "owed" where Debian packages are missing only because MRTA_NO_APT forbade apt, else "settled"
#   checkout     its path, for virtual environments do not move
#   interpreter  the Python beneath .venv, and the system's
#   ros          what is there of ROS
#   sources      digest of the declared dependencies and of the bootstrap itself
#   messages     digest of the message definitions

stamp=${checkout:?}/.venv/set-up
declare -A stamped=() current=()

# Print what a set-up for a level has to do: nothing, messages (only generate their classes), all, or remake (from nothing).
what_to_do() {
    local level=$1 name
    read_stamp
    look_around
    if [[ ! -x $checkout/.venv/bin/python || -z ${stamped[level]:-} ]]; then
        echo all
        return
    fi
    for name in checkout interpreter; do
        [[ ${stamped[$name]:-} == "${current[$name]}" ]] || { echo remake && return; }
    done
    for name in ros sources; do
        [[ ${stamped[$name]:-} == "${current[$name]}" ]] || { echo all && return; }
    done
    if [[ $level == test && ${stamped[level]} != test ]] || { [[ ${stamped[apt]:-} == owed ]] && apt_is_allowed; }; then
        echo all
    elif [[ ${stamped[messages]:-} != "${current[messages]}" ]]; then
        echo messages
    else
        echo nothing
    fi
}

# Fill "stamped" with what the last finished set-up left.
read_stamp() {
    local name value
    stamped=()
    [[ -e $stamp ]] || return 0
    while read -r name value; do
        stamped[${name:-?}]=$value
    done <"$stamp"
}

# Fill "current" with what a set-up depends on.
look_around() {
    look_at_machine
    current[sources]=$(digest 'setup.py' 'bootstrap/*.py' 'bootstrap/*.sh')
    current[messages]=$(digest 'msg/*.msg' 'srv/*.srv' 'plugins/*/*/msg/*.msg' 'plugins/*/*/srv/*.srv')
}

look_at_machine() {
    local path ros=
    for path in /opt/ros/*/setup.bash /usr/lib/python3/dist-packages/{rospy,genpy}/__init__.py; do
        [[ ! -e $path ]] || ros+="$path "
    done
    current[checkout]=$checkout
    current[interpreter]=$(readlink -f -- "$checkout/.venv/bin/python") || true
    current[interpreter]+=:$(readlink -f -- /usr/bin/python3) || true
    current[ros]=${ros% }
}

# Print one checksum over the names and contents of files, given as patterns relative to the checkout.
digest() (
    shopt -s nullglob
    cd -- "$checkout" || return
    # shellcheck disable=SC2206 # patterns are expanded here
    files=($*)
    sum=$(sha256sum -- /dev/null "${files[@]}" | sha256sum)
    printf '%s' "${sum%% *}"
)

# Leave a stamp, whole or not at all. The machine is looked at anew, for the set-up may have brought Python and ROS;
# digests of the files stay those from before, so that no later change is lost.
write_stamp() {
    local level=$1 apt=$2 name
    look_at_machine
    {
        printf 'level %s\napt %s\n' "$level" "$apt"
        for name in checkout interpreter ros sources messages; do
            printf '%s %s\n' "$name" "${current[$name]}"
        done
    } >"$stamp.new"
    mv -f -- "$stamp.new" "$stamp"
}
