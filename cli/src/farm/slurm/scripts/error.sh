# The end of the error's 95 % interval; null where no honest one is had.
high=$(sed -n 's/^ *"high": \([^,]*\),*$/\1/p' merged.json | tail -n 1)
if [ "$high" != null ] && below "$high" @target@; then
    echo "the relMSE is below @target@: the 95 % interval ends at $high"
    exit
fi
