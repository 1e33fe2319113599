# Sourced by the scripts of this repository: installs Debian packages that are missing, and
# configures, builds and tests a preset.
#
#   need PACKAGE...          installs those that are not there yet, and says which
#   build PRESET [TARGET...] configures and builds build/PRESET
#   ctest_of PRESET          runs its tests

unset CDPATH  # with it cd may print where it went
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$top" || exit 1

die() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 1
}

# Is there what the package would bring? A copy from elsewhere is as good.
present() {
    case $1 in
        g++ | cmake | python3 | make | git | gcovr) command -v "$1" > /dev/null ;;
        ninja-build) command -v ninja > /dev/null ;;
        clang) command -v clang++ > /dev/null ;;
        pkg-config) command -v pkg-config > /dev/null ;;
        libgtest-dev) [ -n "$(find /usr/lib /usr/lib64 /usr/local/lib /usr/local/lib64 -name 'libgtest_main.*' -print -quit 2> /dev/null)" ] ;;
        *) dpkg-query -W -f '${Status}' "$1" 2> /dev/null | grep -q 'install ok installed' ;;
    esac
}

root=()
[ "$(id -u)" = 0 ] || root=(sudo)

need() {
    local missing=() package log
    for package in "$@"; do
        present "$package" || missing+=("$package")
    done
    [ ${#missing[@]} = 0 ] && return
    command -v apt-get > /dev/null || die "missing: ${missing[*]} (Debian's names), and there is no apt-get to install them"
    [ ${#root[@]} = 0 ] || command -v sudo > /dev/null ||
        die "missing: ${missing[*]}; run this as root, or install sudo, or install them yourself"
    echo "Installing with apt-get: ${missing[*]}"
    log=$(mktemp)
    if ! apt_install "${missing[@]}" > "$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        die "apt-get could not install: ${missing[*]}"
    fi
    rm -f "$log"
    for package in "${missing[@]}"; do
        present "$package" || die "$package is installed, but what it should bring is not there"
    done
}

# Package lists may be absent or out of date: fetch them if there are none, or if the install fails.
apt_install() {
    # Another apt-get may be at work, as after the start of a machine.
    local install=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "$@")
    if compgen -G '/var/lib/apt/lists/*_Packages*' > /dev/null && "${install[@]}"; then
        return
    fi
    "${root[@]}" apt-get update || { sleep 30 && "${root[@]}" apt-get update; } || return
    "${install[@]}"
}

jobs=$(nproc 2> /dev/null || echo 2)

# A build folder made by another generator, or in another place, can't be configured again.
drop_foreign() { # FOLDER
    local cache=$1/CMakeCache.txt
    if [ -f "$cache" ] && ! { grep -q '^CMAKE_GENERATOR:INTERNAL=Ninja$' "$cache" &&
        grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$top" "$cache"; }; then
        rm -rf "$1"
    fi
}

build() {
    local preset=$1 target targets=()
    shift
    drop_foreign "build/$preset"
    for target in "$@"; do targets+=(--target "$target"); done
    quietly cmake --preset "$preset" || return 1
    quietly cmake --build --preset "$preset" -j "$jobs" "${targets[@]}"
}

# Shows what a command printed only if it failed.
quietly() {
    local log status=0
    log=$(mktemp)
    "$@" > "$log" 2>&1 || status=$?
    [ $status = 0 ] || cat "$log" >&2
    rm -f "$log"
    return $status
}

# Runs a preset's tests: progress in place on a terminal, else only failures and the summary.
# build/PRESET/ctest.log has it all.
ctest_of() {
    local command=(ctest --preset "$1" -j "$jobs")
    # With more address randomness than 28 bits the sanitizers' runtimes of clang 14 may fail to start.
    if [ "$(cat /proc/sys/vm/mmap_rnd_bits 2> /dev/null || echo 0)" -gt 28 ] && setarch -R true 2> /dev/null; then
        command=(setarch -R "${command[@]}")
    fi
    if [ -t 1 ]; then
        "${command[@]}" --progress --output-log "build/$1/ctest.log"
    else
        "${command[@]}" | tee "build/$1/ctest.log" | grep -vE '^ +Start |  Passed  |sec\*proc|^Label Time|^Test project|^$'
    fi
}
