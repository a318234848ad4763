# The upper end of the error's 95 % interval; null if there is no reliable one.
high=$(sed -n 's/^ *"high": \([^,]*\),*$/\1/p' merged.json | tail -n 1)
if [ "$high" != null ] && below "$high" @target@; then
    echo "the relMSE is below @target@: the 95 % interval ends at $high"
    exit
fi
