# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# Run time of the full quadrature and errors of the laws over the gap.

set terminal svg size 900,400
set output "cost_and_error.svg"
set datafile separator ","
set logscale xy
set format y "10^{%T}"
set xlabel "g/R"
set key left bottom
set multiplot layout 1,2
fibers(name, column) = (stringcolumn(2) eq name && $1 == 6 ? column : NaN)
set ylabel "CPU time [s], m = 6"
plot for [name in '"parallel" "crossing, 90 deg"'] "cost_and_error.csv" \
  using 3:(fibers(name, $8)) with linespoints title name." 6D", \
  "" using 3:(fibers("parallel", $10)) with linespoints title "parallel, SBIP"
set ylabel "relative error, parallel, m = 6"
plot "cost_and_error.csv" using 3:(fibers("parallel", $4)) with linespoints \
  title "6D, estimate", \
  "" using 3:(fibers("parallel", abs($9))) with linespoints title "SBIP", \
  "" using 3:(fibers("parallel", abs($11))) with linespoints title "SSIP"
unset multiplot
