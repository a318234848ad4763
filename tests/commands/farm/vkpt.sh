# A program that stands for vkpt: a state is a line for each sample that it contains, as is a picture; the error is 1 over
# their number. Of a state that it has not written it says so, with exit code 3.
set -euo pipefail

merge() {
    local parts=() to='' json=''
    while (($#)); do
        case $1 in
            -o) to=$2 && shift ;;
            --json) json=$2 && shift ;;
            *) parts+=("$1") ;;
        esac
        shift
    done
    sort -n "${parts[@]}" >"$to"
    awk 'END { printf "{\n  \"error\": [\n    {\n      \"high\": %g,\n    }\n  ]\n}\n", 1 / NR }' "$to" >"$json"
}

render() {
    local samples='' to='' stop='' next
    while (($#)); do
        case $1 in
            --samples) samples=$2 && shift ;;
            -o) to=$2 && shift ;;
        esac
        shift
    done
    touch "$to"
    if grep -qv '^[0-9]*$' "$to"; then
        echo "error: $to is no state" >&2
        exit 3
    fi
    next=$((${samples%..*} + $(wc -l <"$to")))
    # A second signal ends it at once.
    trap '[ -z "$stop" ] || exit 99; stop=1' TERM
    for (( ; next < ${samples#*..}; next++)); do
        [ -z "$stop" ] || exit 143
        sleep "${SECONDS_A_SAMPLE:-0}"
        echo "$next" >>"$to"
    done
}

if [ "$1" = merge ]; then merge "${@:2}"; else render "$@"; fi
