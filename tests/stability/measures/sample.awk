# SPDX-License-Identifier: GPL-3.0-or-later
# What the measures read: rows of postProcessing/<function>/<file> of the case in the current directory, and figures of its logs.

# readRows(file, rows): rows[i, c], i = 1 ... returned number, c = 1 the time.
function readRows(file, rows,    line, field, i, n, c)
{
    file = "postProcessing/" file
    n = 0
    while ((getline line < file) > 0)
    {
        if (line ~ /^#/) continue
        gsub(/[()]/, " ", line)
        c = split(line, field, " ")
        ++n
        for (i = 1; i <= c; ++i) rows[n, i] = field[i] + 0
    }
    close(file)
    if (n == 0) { print "no samples in " file; exit 1 }
    return n
}

# The number after the text at the beginning of the last line of the log that has it.
function logged(program, text,    line, found, file)
{
    file = "log." program
    found = ""
    while ((getline line < file) > 0)
    {
        if (index(line, text) == 1) found = substr(line, length(text) + 1) + 0
    }
    close(file)
    if (found == "") { print "no '" text "' in " file; exit 1 }
    return found
}

function abs(x) { return x < 0 ? -x : x }
function max(a, b) { return a > b ? a : b }
