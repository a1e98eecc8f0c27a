# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot pair.gnuplot in the folder with charged_pair_centerlines.csv and
# charged_pair_forces.csv draws charged_pair.png.

set terminal pngcairo size 1000,440 font 'sans,11'
set output 'charged_pair.png'
set datafile separator ','
set size ratio -1
set xrange [-0.2:5.2]
set yrange [-0.2:5.2]
set xlabel 'x'
set ylabel 'y'
set palette defined (0 '#3b4cc0', 0.5 '#b0b0b0', 1 '#b40426')
set multiplot layout 1,2

set title 'equilibria for k = 0.1 to 1'
set cblabel 'k'
set cbrange [0:1]
plot 'charged_pair_centerlines.csv' skip 1 using 3:4:1 with lines \
       linewidth 2 palette notitle

# The arrows point to where the fiber is pulled; their length is a force per
# length.
set title 'force per length at the Gauss points, k = 1'
unset cblabel
stats 'charged_pair_forces.csv' skip 1 using (sqrt($3**2 + $4**2)) nooutput
scale = 0.4/STATS_max
set cbrange [0:STATS_max]
plot 'charged_pair_forces.csv' skip 1 using 1:2:(scale*$3):(scale*$4):(sqrt($3**2 + $4**2)) \
       with vectors filled head size 0.08,15 palette notitle, \
     '< grep "^1," charged_pair_centerlines.csv' using ($2 == 0 ? $3 : NaN):4 with lines \
       linewidth 2 linecolor 'black' notitle, \
     '' using ($2 == 1 ? $3 : NaN):4 with lines linewidth 2 linecolor 'black' notitle
