# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot work_precision.gnuplot in the folder with work_precision.csv draws work_precision.png.

set terminal pngcairo size 800,560 font 'sans,11'
set output 'work_precision.png'
set datafile separator ','
set logscale xy
set format xy '10^{%T}'
set grid
set xlabel 'CPU time of the run [s]'
set ylabel 'relative error of the force peak'
plot '< grep disk-cylinder work_precision.csv' using 6:4 with points \
       pointtype 7 title 'SBIP (disk-cylinder)', \
     '< grep disk-disk work_precision.csv' using 6:4 with points \
       pointtype 5 title 'SSIP (disk-disk)'
