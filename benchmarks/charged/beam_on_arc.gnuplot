# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot beam_on_arc.gnuplot in the folder with beam_on_arc_curves.csv and
# beam_on_arc_errors.csv draws beam_on_arc.png.

set terminal pngcairo size 1300,440 font 'sans,11'
set output 'beam_on_arc.png'
set datafile separator ','
set grid
set multiplot layout 1,3
laws = "disk-cylinder tabulated-disk-cylinder disk-disk"

set xlabel 'time'
set key bottom center
set ylabel 'vertical reaction'
plot for [law in laws] sprintf("< grep '^%s,128 x 5,' beam_on_arc_curves.csv", law) \
       using 3:4 with lines linewidth 2 title law, \
     for [n in "30 50"] sprintf("< grep '^disk-disk,%s x 5,' beam_on_arc_curves.csv", n) \
       using 3:4 with lines dashtype 2 title sprintf('disk-disk, %s segments', n)

set ylabel 'interaction energy'
set format y '%.0e'
plot for [law in laws] sprintf("< grep '^%s,128 x 5,' beam_on_arc_curves.csv", law) \
       using 3:5 with lines linewidth 2 title law, \
     for [n in "30 50"] sprintf("< grep '^disk-disk,%s x 5,' beam_on_arc_curves.csv", n) \
       using 3:5 with lines dashtype 2 title sprintf('disk-disk, %s segments', n)

set key bottom right font ',9' samplen 2 spacing .9
set yrange [1e-13:]
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'CPU time [s], filled: graded segments'
set ylabel 'relative error of the energy at t = 1'
plot for [i=1:words(laws)] \
       sprintf("< grep '^%s,.* x 5,' beam_on_arc_errors.csv | grep -v ',128 x'", \
               word(laws, i)) \
       using 7:4 with linespoints pointtype 6 linecolor i \
       title word(laws, i), \
     for [i=1:words(laws)] \
       sprintf("< grep '^%s,graded' beam_on_arc_errors.csv", word(laws, i)) \
       using 7:4 with linespoints pointtype 7 linecolor i notitle
