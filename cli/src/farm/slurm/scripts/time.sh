# Another round takes about as long as all before it; 1 allows for fractions of seconds.
if below @seconds@ $((2 * ($(date +%s) - $(<started) + 1))); then
    echo "another round would end more than @seconds@ s after the first part started"
    exit
fi
