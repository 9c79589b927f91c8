# shellcheck shell=bash
# Which Python .venv is built on.

: "${checkout:?}"

# Print the interpreter to build on: the system's, else python3 from PATH; a version manager's shim comes last, resolved.
find_python() {
    local system=$1 folder candidate
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

# Install Python by apt where that is allowed and possible, and print it; without success 4, as for anything missing.
install_python() {
    local -a as_root=()
    ((EUID == 0)) || as_root=(sudo -n)
    if apt_is_allowed && command -v apt-get >/dev/null && "${as_root[@]}" true 2>/dev/null; then
        say "installing with ${as_root[*]}${as_root:+ }apt-get: python3 python3-venv"
        {
            "${as_root[@]}" apt-get -qq update || true
            "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
                -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 install python3 python3-venv || true
        } </dev/null >/dev/null
        find_python /usr/bin/python3 && return
    fi
    say "no Python from 3.8 on was found; install the packages python3 and python3-venv"
    return 4
}
