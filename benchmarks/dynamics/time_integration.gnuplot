# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot time_integration.gnuplot in the folder with time_integration.csv draws
# time_integration.png.

set terminal pngcairo size 1500,500 font 'sans,11'
set output 'time_integration.png'
set datafile separator ','
set logscale xy
set format xy '10^{%T}'
set grid
set xlabel 'CPU time of the run [s]'
set ylabel 'error of the nodes [length]'
set multiplot layout 1,3
do for [phase in "flight contact snap"] {
  set title phase
  plot sprintf("< grep '%s,equal' time_integration.csv", phase) using 7:6 \
         with linespoints pointtype 7 title 'generalized-alpha, equal steps', \
       sprintf("< grep '%s,conserving' time_integration.csv", phase) using 7:6 \
         with linespoints pointtype 13 title 'energy-conserving, equal steps', \
       sprintf("< grep '%s,adapted' time_integration.csv", phase) using 7:6 \
         with linespoints pointtype 5 title 'generalized-alpha, adapted steps', \
       sprintf("< grep '%s,IDA' time_integration.csv", phase) using 7:6 \
         with linespoints pointtype 9 title 'IDA'
}
