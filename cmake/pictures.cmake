# Draws the pictures of docs and the README that `assur draw` makes of the examples.
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

# Draws scenes, each in one configuration (`scene:configuration`), as pictures inside a picture, under
# titles. Each is `width` by `height` large at most.
function(sheet file columns width height scenes titles)
  set(title_height 26)
  list(LENGTH scenes count)
  math(EXPR cell_width "${width} + 10")
  math(EXPR cell_height "${height} + ${title_height}")
  math(EXPR sheet_width "${columns} * ${cell_width}")
  math(EXPR sheet_height "(${count} + ${columns} - 1) / ${columns} * ${cell_height}")
  set(sheet "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"${sheet_width}\" ")
  string(APPEND sheet "height=\"${sheet_height}\" viewBox=\"0 0 ${sheet_width} ${sheet_height}\">\n")
  string(APPEND sheet "<rect class=\"paper\" width=\"${sheet_width}\" height=\"${sheet_height}\"/>\n")
  set(place 0)
  foreach(scene title IN ZIP_LISTS scenes titles)
    string(REPLACE ":" ";" parts ${scene})
    list(GET parts 0 name)
    list(GET parts 1 configuration)
    get_filename_component(stem ${name} NAME)
    draw(${name} ${WORK}/${stem}.svg --configuration ${configuration})
    file(READ ${WORK}/${stem}.svg picture)
    math(EXPR x "${place} % ${columns} * ${cell_width} + 5")
    math(EXPR y "${place} / ${columns} * ${cell_height}")
    math(EXPR middle "${x} + ${width} / 2")
    math(EXPR base "${y} + 19")
    math(EXPR top "${y} + ${title_height}")
    string(REGEX REPLACE "width=\"80mm\" height=\"[^\"]*\""
      "x=\"${x}\" y=\"${top}\" width=\"${width}\" height=\"${height}\"" picture "${picture}")
    string(REGEX REPLACE " data-[a-z]+=\"[^\"]*\"" "" picture "${picture}")
    if(place GREATER 0)  # the first one's style serves all
      string(REGEX REPLACE "<style>.*</style>\n" "" picture "${picture}")
    endif()
    string(APPEND sheet "<text class=\"title\" x=\"${middle}\" y=\"${base}\">${title}</text>\n")
    string(APPEND sheet "${picture}")
    math(EXPR place "${place} + 1")
  endforeach()
  string(APPEND sheet "<style>.title{text-anchor:middle;font:bold 13px sans-serif}</style>\n</svg>\n")
  file(WRITE ${file} "${sheet}")
endfunction()

sheet(${OUTPUT}/scenes.svg 3 320 360
  "four_bar_coupler_curve:1;slider_crank:1;shaper_quick_return:1;\
watt_six_bar:1;stephenson_triad:1;jansen_leg:3;\
excavator_arm:10;gripper:8;scissor_lift:8"
  "Four-bar with a coupler curve;Slider-crank;Shaper;\
Watt's six-bar;Stephenson's six-bar, a triad;Jansen's leg;\
Excavator's arm on cylinders;Gripper;Scissor lift")

# All configurations of a scene of each of the seven-link chains.
foreach(count 18 16 14)
  set(scenes "")
  set(numbers "")
  foreach(configuration RANGE 1 ${count})
    list(APPEND scenes ../docs/method/seven_links_${count}:${configuration})
    list(APPEND numbers ${configuration})
  endforeach()
  sheet(${OUTPUT}/../method/seven_links_${count}.svg 6 160 110 "${scenes}" "${numbers}")
endforeach()
