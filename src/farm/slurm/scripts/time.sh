# Another round takes about as long as all before it.
if below @seconds@ $((2 * ($(date +%s) - $(<started)))); then
    echo "another round would end later than @seconds@ s after the first part began"
    exit
fi
