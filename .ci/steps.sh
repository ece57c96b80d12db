# What the scripts of this folder share. Source it in the root of the repository.
#
# A step prints its command and its time; at the end there is a table of all steps. A tool that is missing is named with
# the way to get it, and the script goes on without the steps that need it. Only where CI=true (a machine that is thrown
# away afterwards) is it installed.

step_times=()
not_run=()

# A step is a process of its own, so that its first command that fails ends it.
step() {
    local started=$SECONDS code verdict=""
    printf '\n== %s\n' "$*"
    set +e
    ( set -e; "$@" )
    code=$?
    set -e
    [ $code = 0 ] || verdict="failed: "
    step_times+=("$((SECONDS - started))	$verdict$*")
    return $code
}

# need COMMAND PACKAGES WHAT: whether a command is there, which WHAT needs.
need() {
    command -v "$1" > /dev/null && return
    if [ "${CI:-}" = true ] && [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null; then
        # shellcheck disable=SC2086 # several packages
        step install_packages $2
        command -v "$1" > /dev/null && return
    fi
    not_run+=("$3: needs $1; on Debian and Ubuntu: apt-get install $2")
    return 1
}

# need_target TARGET WHAT: whether the compiler has the standard library of a target, which WHAT needs.
need_target() {
    [ -d "$(rustc --print target-libdir --target "$1")" ] && return
    if [ "${CI:-}" = true ] && rustup target add "$1"; then
        return
    fi
    not_run+=("$2: needs the standard library of Rust for $1; with rustup: rustup target add $1")
    return 1
}

install_packages() {
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$@" > /dev/null
}

# At the end: the time of each step, what was not run, and the verdict. A machine of CI has to run everything.
print_summary() {
    local code=$? line
    if [ ${#step_times[@]} -gt 0 ]; then
        printf '\n  time  step\n'
        for line in "${step_times[@]}"; do
            printf '%4d s  %s\n' "${line%%	*}" "$(cut -c1-100 <<< "${line#*	}")"
        done
    fi
    for line in "${not_run[@]}"; do
        printf 'not run: %s\n' "$line"
    done
    if [ $code = 0 ] && [ ${#not_run[@]} -gt 0 ] && [ "${CI:-}" = true ]; then
        code=1
    fi
    exit $code
}
trap print_summary EXIT
