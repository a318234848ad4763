#!/usr/bin/env bash
# Submits the parts that are not yet rendered, and a merge that waits for them. Run it again if parts have failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. ./farm.sh
if ! command -v sbatch >/dev/null; then
    echo "sbatch is not installed here: run submit.sh on a machine that submits to Slurm" >&2
    exit 1
fi
mkdir -p parts/unfinished logs

jobs='' todo=$(missing)
for ((offset = 0; offset < $(wc -l <parts.txt); offset += most)); do
    tasks=$(awk -v o="$offset" -v n="$most" '$1 > o && $1 <= o + n { print $1 - o }' <<<"$todo" | paste -sd,)
    if [ -n "$tasks" ]; then
        job=$(sbatch --parsable --array="$tasks" part.sbatch "$offset")
        jobs+=:${job%;*}
        echo "parts: job ${job%;*}"
    fi
done

# After any end: a merge that waits for success would wait forever if a part failed.
after=()
if [ -n "$jobs" ]; then after=(--dependency="afterany$jobs"); fi
job=$(sbatch --parsable "${after[@]}" merge.sbatch)
echo "merge: job ${job%;*}, log in $folder/logs/merge-${job%;*}.log"
