# Errors of a table of the program body at the places that its benchmark wrote; behind the cells of row: log10 of the relative
# L2 error, the relative local error of a quantity, and the seconds.
# Use: awk -v row=CELLS -v quantity=NAME -f errors.awk PLACES TABLE
function size(number) { return number < 0 ? -number : number }
function larger(a, b) { return a > b ? a : b }
NR == FNR {
    weight[NR] = $3
    exact1[NR] = $4
    exact2[NR] = $5
    next
}
/^#/ { next }
{
    split($0, cell, ",")
    name = cell[3]
    value = cell[6]
}
name == "seconds" { seconds = value }
cell[4] == "" || name ~ /^(max_|quality)/ { next }
name == "u" || name == "u1" {
    ++place
    difference += weight[place] * (value - exact1[place]) ^ 2
    norm += weight[place] * (exact1[place] ^ 2 + exact2[place] ^ 2)
}
name == "u2" { difference += weight[place] * (value - exact2[place]) ^ 2 }
name == quantity && weight[place] == 0 {
    error = larger(error, size(value - exact1[place]))
    largest = larger(largest, size(exact1[place]))
}
END {
    if (place != length(weight) || largest == 0 || seconds == "") {
        print "errors.awk: " row ": " place + 0 " places instead of " length(weight) ", " quantity " or the seconds are missing" > "/dev/stderr"
        exit 1
    }
    printf "%s,%.5f,%.4g,%.4g\n", row, log(difference / norm) / log(100), error / largest, seconds
}
