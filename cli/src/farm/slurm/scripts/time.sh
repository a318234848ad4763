# Another round takes about as long as all before it; 1 makes up for parts of seconds.
if below @seconds@ $((2 * ($(date +%s) - $(<started) + 1))); then
    echo "another round would end later than @seconds@ s after the first part began"
    exit
fi
