# Figure 4. A drawing: reads no table and no value.
load '../fig03_settling_rig/column.gp'

# Laser with its sheet, field of view, camera.
set object 31 rectangle from 20,170 to 90,205 fillcolor rgb '#3b434d' fillstyle solid noborder
set object 32 polygon from 90,187 to 165,215 to 195,222 to 195,152 to 165,160 to 90,187 \
  fillcolor rgb '#36b24a' fillstyle transparent solid 0.35 noborder front
set object 33 rectangle from 165,155 to 195,220 fillstyle empty border linecolor rgb variant linewidth 2 front
set object 34 rectangle from 300,172 to 350,204 fillcolor rgb '#3b434d' fillstyle solid noborder
set object 35 polygon from 300,180 to 284,172 to 284,204 to 300,196 to 300,180 \
  fillcolor rgb metal fillstyle solid noborder
set arrow 31 from 284,176 to 196,156 nohead linecolor rgb quiet dashtype 3 front
set arrow 32 from 284,200 to 196,219 nohead linecolor rgb quiet dashtype 3 front

# Synchroniser and computer, and their lines to laser and camera.
set object 36 rectangle from 230,20 to 310,52 fillcolor rgb '#f4f7f9' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.2
set object 37 rectangle from 345,20 to 415,52 fillcolor rgb '#f4f7f9' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.2
set arrow 33 from 230,36 to 55,36 nohead linecolor rgb metal linewidth 1.4 back
set arrow 34 from 55,36 to 55,168 head filled size 6,20 linecolor rgb metal linewidth 1.4
set arrow 35 from 310,45 to 325,45 nohead linecolor rgb metal linewidth 1.4
set arrow 36 from 325,45 to 325,170 head filled size 6,20 linecolor rgb metal linewidth 1.4
set arrow 37 from 345,36 to 310,36 nohead linecolor rgb metal linewidth 1.4
set arrow 38 from 340,172 to 380,54 head filled size 6,20 linecolor rgb metal linewidth 1.4

set label 1 'laser, 1000 Hz' at 55,222 center font ',12'
set label 2 'sheet through the axis' at 62,262 left font ',12' textcolor rgb '#23803a'
set arrow 39 from 100,254 to 130,202 nohead linecolor rgb '#23803a' front
set label 3 'field of view, 50 × 50 mm' at 216,246 font ',12' textcolor rgb variant
set arrow 40 from 214,243 to 196,221 nohead linecolor rgb variant front
set label 4 'camera, 900 Hz' at 325,222 center font ',12'
set label 5 'synchroniser' at 270,36 center font ',12'
set label 6 'computer' at 380,36 center font ',12'
set label 7 'column in its jacket, both filled with NaI solution' at 216,400 font ',12'
set arrow 41 from 214,400 to 190,404 nohead linecolor rgb quiet front
set label 8 'foreign sphere' at 216,318 font ',12' textcolor rgb '#c0392b'
set label 9 'distributor' at 216,116 font ',12'
set label 10 'calming section' at 216,84 font ',12' textcolor rgb law_three
plot [0:460] [0:500] @column_spheres
