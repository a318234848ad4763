# The rendering and its folder. part.sbatch, merge.sbatch and submit.sh read this file.
# shellcheck shell=bash disable=SC2016,SC2034
vkpt=@vkpt@
rendering=(@rendering@)
pictures=(@pictures@)
folder=@folder@
# The most tasks of one array: Slurm's MaxArraySize, by default 1001, must be above it.
most=1000

# The command that renders samples $1 to $2 into $unfinished. It continues that file, if it exists.
command_of() {
    unfinished=$folder/parts/unfinished/$1-$2.vkpt
    finished=$folder/parts/$1-$2.vkpt
    command=("$vkpt" "${rendering[@]}" --samples "$1..$2" --resume -o "$unfinished")
}

# Number, first sample and end of each part that is not yet rendered, in the rounds up to the one in the file `round`.
missing() {
    local number=0 current round first end
    current=$(<"$folder/round")
    while read -r round first end; do
        number=$((number + 1))
        if ((round <= current)) && [ ! -e "$folder/parts/$first-$end.vkpt" ]; then
            echo "$number $first $end"
        fi
    done <"$folder/parts.txt"
}
