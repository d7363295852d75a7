#include <fmt/format.h>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"

namespace slfb {
namespace {

std::vector<std::string> needs(const Profile&) { return {}; }

/// What both rigs share, in millimetres of the picture: column in its square jacket, calming section, distributor, the
/// spheres of the bed on a staggered lattice, and the water in blue.
constexpr const char* column = R"(unset grid
unset key
unset border
unset tics
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
water = '#cfe5f5'
glass = '#8fb6d6'
metal = '#5b6470'
set style line 41 linecolor rgb '#2b3138' linewidth 1.5
set style line 42 linecolor rgb ours linewidth 2.2
set object 1 rectangle from 150,110 to 210,470 fillcolor rgb '#e9f3fa' fillstyle solid border linecolor rgb glass linewidth 1.2 behind
set object 2 rectangle from 165,110 to 195,480 fillcolor rgb water fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4
set object 3 rectangle from 165,60 to 195,108 fillcolor rgb '#efe6d2' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4
set object 4 rectangle from 160,107 to 200,112 fillcolor rgb metal fillstyle solid noborder front
bed_x(i) = 167.5 + 3.3*((i % 8) + 0.5*((i/8) % 2))
bed_y(i) = 115.5 + 3.6*(i/8)
calming_x(i) = 168.2 + 5.2*((i % 5) + 0.5*((i/5) % 2))
calming_y(i) = 64 + 4.9*(i/5)
set samples 300
)";

std::string plot(const std::string& more) {
  return "plot [0:" + more +
         "] [0:500] '+' using (bed_x(int($0))):(bed_y(int($0))):(int($0) < 272 ? 1.45 : NaN) with circles fillstyle "
         "solid "
         "noborder linecolor rgb ours, '+' using (calming_x(int($0))):(calming_y(int($0))):(int($0) < 45 ? 2.2 : NaN) "
         "with "
         "circles fillstyle solid noborder linecolor rgb law_three, '+' using (int($0) == 0 ? 180 : NaN):(318):(2.4) "
         "with "
         "circles fillstyle solid noborder linecolor rgb '#c0392b'\n";
}

FigureOutput draw_settling_rig(const FigureContext& context) {
  FigureOutput output{"fig03", {}, "", {"No simulation stands behind this picture."}};
  output.caption =
      "Rig of the settling experiments, drawn from the paper's description; not to scale. A pump circulates the liquid "
      "from "
      "the tank through a rotameter and a calming section of glass beads to the perforated distributor (128 holes of 2 "
      "mm) "
      "and the column, 50 mm wide and 1.5 m high, in a square jacket of the same liquid. The steel sphere is let in at "
      "the "
      "top and filmed at 500 frames a second. Nothing of this is simulated: the simulation begins at the distributor.";
  const std::string script = std::string(column) + R"(
# The loop: tank, pump, valve, rotameter, inlet; overflow and heat exchanger back to the tank.
set object 11 rectangle from 290,30 to 390,110 fillcolor rgb water fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4
set object 12 circle at 255,45 size 13 fillcolor rgb '#ffffff' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4 front
set object 13 rectangle from 62,150 to 78,230 fillcolor rgb '#f4f7f9' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4 front
set object 14 polygon from 65,185 to 75,185 to 70,175 to 65,185 fillcolor rgb variant fillstyle solid noborder front
set object 15 rectangle from 320,260 to 360,320 fillcolor rgb '#fbe9dc' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4 front
set object 16 polygon from 128,38 to 128,52 to 148,38 to 148,52 to 128,38 fillcolor rgb '#ffffff' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4 front
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
# Camera on the left, and the sphere's way in.
set object 21 rectangle from 18,300 to 62,330 fillcolor rgb '#3b434d' fillstyle solid noborder
set object 22 polygon from 62,307 to 76,302 to 76,328 to 62,323 to 62,307 fillcolor rgb metal fillstyle solid noborder
set arrow 24 from 78,315 to 148,330 nohead linecolor rgb quiet dashtype 3
set arrow 25 from 78,315 to 148,300 nohead linecolor rgb quiet dashtype 3
set object 23 polygon from 170,497 to 190,497 to 183,484 to 177,484 to 170,497 fillcolor rgb '#ffffff' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.2 front
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
)" + plot("430");
  draw_figure("fig03", script, {645, 750}, context.out);
  return output;
}

FigureOutput draw_velocimetry_rig(const FigureContext& context) {
  FigureOutput output{"fig04", {}, "", {"No simulation stands behind this picture."}};
  output.caption =
      "Particle image velocimetry in the bed, drawn from the paper's description; not to scale. A laser sheet lights "
      "fluorescent tracers in the plane through the axis, a camera beside it takes pairs of pictures of 50 × 50 mm at "
      "900 "
      "Hz, and a synchroniser times both. The sodium iodide solution has the refractive index of the glass, 1.472, so "
      "that "
      "the bed is transparent. Its results, the experimental points of Figure 12, are not available as numbers.";
  const std::string script = std::string(column) + R"(
unset object 3
unset object 4
set object 3 rectangle from 165,60 to 195,108 fillcolor rgb '#efe6d2' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.4
set object 4 rectangle from 160,107 to 200,112 fillcolor rgb metal fillstyle solid noborder front
set object 31 rectangle from 20,170 to 90,205 fillcolor rgb '#3b434d' fillstyle solid noborder
set object 32 polygon from 90,187 to 165,215 to 195,222 to 195,152 to 165,160 to 90,187 fillcolor rgb '#36b24a' fillstyle transparent solid 0.35 noborder front
set object 33 rectangle from 165,155 to 195,220 fillstyle empty border linecolor rgb variant linewidth 2 front
set object 34 rectangle from 300,172 to 350,204 fillcolor rgb '#3b434d' fillstyle solid noborder
set object 35 polygon from 300,180 to 284,172 to 284,204 to 300,196 to 300,180 fillcolor rgb metal fillstyle solid noborder
set arrow 31 from 284,176 to 196,156 nohead linecolor rgb quiet dashtype 3 front
set arrow 32 from 284,200 to 196,219 nohead linecolor rgb quiet dashtype 3 front
set object 36 rectangle from 230,20 to 310,52 fillcolor rgb '#f4f7f9' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.2
set object 37 rectangle from 345,20 to 415,52 fillcolor rgb '#f4f7f9' fillstyle solid border linecolor rgb '#2b3138' linewidth 1.2
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
)" + plot("460");
  draw_figure("fig04", script, {690, 750}, context.out);
  return output;
}

}  // namespace

Figure fig03() {
  return {"fig03", "Rig of the settling experiments", needs, draw_settling_rig, "peng_2014/fig03_rigs"};
}

Figure fig04() {
  return {"fig04", "Particle image velocimetry in the bed", needs, draw_velocimetry_rig, "peng_2014/fig03_rigs"};
}

}  // namespace slfb
