# Turns the examples into the pictures of docs/guide and the README that `assur draw` makes.
# cmake -DASSUR=build/assur -DEXAMPLES=examples -DOUTPUT=docs/guide -DWORK=build/pictures -P pictures.cmake
file(MAKE_DIRECTORY ${WORK})

function(draw scene file)
  execute_process(COMMAND ${ASSUR} draw ${EXAMPLES}/${scene}.json --output ${file} ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

draw(quintero_2011_rrp_rrr ${OUTPUT}/drawing_all.svg)
draw(excavator_arm ${OUTPUT}/drawing_one.svg --nearest)
draw(crane ${OUTPUT}/forces_arrows.svg --nearest)
draw(jansen_leg ${OUTPUT}/drawing_moving.svg --moving --configuration 2)

# Nine scenes, each in one configuration, three in a row: pictures inside a picture, at their size.
set(cell_width 330)
set(cell_height 360)
set(title_height 26)
set(scenes
  four_bar_coupler_curve:1 slider_crank:1 shaper_quick_return:1
  watt_six_bar:1 stephenson_triad:1 jansen_leg:3
  excavator_arm:10 gripper:8 scissor_lift:8)
set(titles
  "Four-bar with a coupler curve" "Slider-crank" "Shaper"
  "Watt's six-bar" "Stephenson's six-bar, a triad" "Jansen's leg"
  "Excavator's arm on cylinders" "Gripper" "Scissor lift")
math(EXPR width "3 * ${cell_width}")
math(EXPR height "3 * (${cell_height} + ${title_height})")
set(sheet "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"${width}\" height=\"${height}\" ")
string(APPEND sheet "viewBox=\"0 0 ${width} ${height}\">\n<rect class=\"paper\" ")
string(APPEND sheet "width=\"${width}\" height=\"${height}\"/>\n")
set(place 0)
foreach(scene title IN ZIP_LISTS scenes titles)
  string(REPLACE ":" ";" parts ${scene})
  list(GET parts 0 name)
  list(GET parts 1 configuration)
  draw(${name} ${WORK}/${name}.svg --configuration ${configuration})
  file(READ ${WORK}/${name}.svg picture)
  math(EXPR x "${place} % 3 * ${cell_width} + 5")
  math(EXPR y "${place} / 3 * (${cell_height} + ${title_height})")
  math(EXPR middle "${x} + 160")
  math(EXPR base "${y} + 19")
  math(EXPR top "${y} + ${title_height}")
  string(REGEX REPLACE "width=\"80mm\" height=\"[^\"]*\""
    "x=\"${x}\" y=\"${top}\" width=\"320\" height=\"${cell_height}\"" picture "${picture}")
  string(REGEX REPLACE " data-[a-z]+=\"[^\"]*\"" "" picture "${picture}")
  string(APPEND sheet "<text class=\"title\" x=\"${middle}\" y=\"${base}\">${title}</text>\n")
  string(APPEND sheet "${picture}")
  math(EXPR place "${place} + 1")
endforeach()
string(APPEND sheet "<style>.title{text-anchor:middle;font:bold 13px sans-serif}</style>\n</svg>\n")
file(WRITE ${OUTPUT}/scenes.svg "${sheet}")
