# Figure 3. A drawing: reads no table and no value.
load 'column.gp'

# The loop: tank, pump, valve, rotameter, inlet; overflow and heat exchanger back to the tank.
set object 11 rectangle from 290,30 to 390,110 fillcolor rgb water fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4
set object 12 circle at 255,45 size 13 fillcolor rgb '#ffffff' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4 front
set object 13 rectangle from 62,150 to 78,230 fillcolor rgb '#f4f7f9' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4 front
set object 14 polygon from 65,185 to 75,185 to 70,175 to 65,185 fillcolor rgb variant fillstyle solid noborder front
set object 15 rectangle from 320,260 to 360,320 fillcolor rgb '#fbe9dc' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4 front
set object 16 polygon from 128,38 to 128,52 to 148,38 to 148,52 to 128,38 fillcolor rgb '#ffffff' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4 front
set arrow 11 from 290,45 to 268,45 nohead linestyle 42
set arrow 12 from 242,45 to 148,45 nohead linestyle 42
set arrow 13 from 128,45 to 70,45 nohead linestyle 42
set arrow 14 from 70,45 to 70,150 head filled size 6,20 linestyle 42
set arrow 15 from 70,230 to 70,262 nohead linestyle 42
set arrow 16 from 70,262 to 110,262 nohead linestyle 42
set arrow 17 from 110,262 to 110,84 nohead linestyle 42
set arrow 18 from 110,84 to 165,84 head filled size 6,20 linestyle 42
set arrow 20 from 210,455 to 340,455 nohead linestyle 42
set arrow 21 from 340,455 to 340,320 nohead linestyle 42
set arrow 22 from 340,260 to 340,110 head filled size 6,20 linestyle 42
set arrow 23 from 322,280 to 358,300 nohead linecolor rgb law_one linewidth 1.6 front

# The camera on the left, and the sphere's way in.
set object 21 rectangle from 18,300 to 62,330 fillcolor rgb '#3b434d' fillstyle solid noborder
set object 22 polygon from 62,307 to 76,302 to 76,328 to 62,323 to 62,307 fillcolor rgb metal fillstyle solid noborder
set arrow 24 from 78,315 to 148,330 nohead linecolor rgb quiet dashtype 3
set arrow 25 from 78,315 to 148,300 nohead linecolor rgb quiet dashtype 3
set object 23 polygon from 170,497 to 190,497 to 183,484 to 177,484 to 170,497 fillcolor rgb '#ffffff' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.2 front

set label 1 'column, 50 mm' at 216,395 font ',12'
set label 2 'square jacket' at 216,365 font ',12'
set arrow 31 from 214,395 to 190,402 nohead linecolor rgb quiet front
set arrow 32 from 214,365 to 204,366 nohead linecolor rgb quiet front
set label 3 'foreign sphere' at 216,318 font ',12' textcolor rgb '#c0392b'
set label 4 'fluidised bed' at 216,200 font ',12' textcolor rgb ours
set label 5 'distributor' at 216,116 font ',12'
set label 6 'calming section' at 216,84 font ',12' textcolor rgb law_three
set label 7 'pump' at 255,70 center font ',12'
set label 8 'tank' at 340,72 center font ',12'
set label 9 'rotameter' at 54,190 right font ',12'
set label 10 "heat\nexchanger" at 366,297 font ',12'
set label 11 'camera' at 40,345 center font ',12'
set label 12 'valve' at 138,66 center font ',12'
set label 13 'way in of the sphere' at 196,492 font ',12'
plot [0:430] [0:500] @column_spheres
