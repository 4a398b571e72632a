# SPDX-License-Identifier: GPL-3.0-or-later
# The acoustic step maxCo h/c0 over the smallest step of the log (maxCo = 0.25 unless given): how far speed and acceleration
# have shortened it.
BEGIN {
    file = "log.sloshSPHFoam"
    while ((getline line < file) > 0)
    {
        split(line, word, " ")
        if (index(line, "Speed of sound: ") == 1) { c0 = word[4]; h = word[8] }
        if (word[1] == "deltaT" && (least == "" || word[3] < least)) least = word[3]
    }
    printf "%.3g", (maxCo ? maxCo : 0.25)*h/c0/least
}
