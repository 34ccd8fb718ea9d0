# Turns files into one C++ file of functions that return them, so that the tool carries the pivots'
# explorer, the scripts of an export and the shipped scenes with it. Run by
# `cmake -DSOURCES=.. -DFIXTURES=.. -DOUTPUT=.. -P embed_text.cmake`.
#
# The text goes into raw string literals of at most 12 kB, since some compilers take no longer ones;
# they are cut at line ends, never inside a character.

set(largest 12000)

# `variable` becomes the literals of `text`, joined one after the other.
function(literals variable text)
  set(pieces "")
  string(LENGTH "${text}" rest)
  while(rest GREATER 0)
    set(count ${rest})
    if(count GREATER largest)
      string(SUBSTRING "${text}" 0 ${largest} piece)
      string(FIND "${piece}" "\n" end REVERSE)
      if(end LESS 0)
        message(FATAL_ERROR "embed_text: a line of more than ${largest} bytes")
      endif()
      math(EXPR count "${end} + 1")
    endif()
    string(SUBSTRING "${text}" 0 ${count} piece)
    string(SUBSTRING "${text}" ${count} -1 text)
    string(LENGTH "${text}" rest)
    string(APPEND pieces "  text += R\"embedded(${piece})embedded\";\n")
  endwhile()
  set(${variable} "${pieces}" PARENT_SCOPE)
endfunction()

set(definitions "")
# The function `name` returns `text`.
function(embed name text)
  literals(pieces "${text}")
  string(APPEND definitions
         "std::string ${name}() {\n  std::string text;\n${pieces}  return text;\n}\n")
  set(definitions "${definitions}" PARENT_SCOPE)
endfunction()

# The blanks that begin lines say nothing in a page, and are a fifth of it.
function(without_margin variable text)
  string(REGEX REPLACE "\n +" "\n" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

foreach(entry IN ITEMS
        explorer_template=${SOURCES}/pivots/explorer/explorer.html
        explorer_style=${SOURCES}/pivots/explorer/explorer.css
        play_frame=${SOURCES}/play/page/frame.html
        play_body=${SOURCES}/play/page/page.html
        lcp_body=${SOURCES}/play/page/lcp.html
        gallery_template=${SOURCES}/play/page/gallery.html
        play_style=${SOURCES}/play/page/page.css)
  string(REGEX MATCH "^([a-z_]+)=(.*)$" found "${entry}")
  set(name ${CMAKE_MATCH_1})
  file(READ "${CMAKE_MATCH_2}" text)
  without_margin(text "${text}")
  if(name MATCHES "_style$")
    string(REGEX REPLACE "([:;,{}]) +" "\\1" text "${text}")
  endif()
  embed(${name} "${text}")
endforeach()
foreach(entry IN ITEMS
        solver_text=${SOURCES}/play/wasm/solver.txt
        python_script=${SOURCES}/export/solve_push.py
        octave_script=${SOURCES}/export/solve_push.m
        control_loop=${SOURCES}/export/control_loop.c)
  string(REGEX MATCH "^([a-z_]+)=(.*)$" found "${entry}")
  file(READ "${CMAKE_MATCH_2}" text)
  embed(${CMAKE_MATCH_1} "${text}")
endforeach()

# The function `list` returns the name and the text of every file that `pattern` finds.
function(embed_files list pattern)
  file(GLOB files "${pattern}")
  set(entries "")
  foreach(file IN LISTS files)
    cmake_path(GET file STEM name)
    file(READ "${file}" text)
    embed(${list}_${name} "${text}")
    string(APPEND entries "      {\"${name}\", ${list}_${name}()},\n")
  endforeach()
  string(APPEND definitions "std::vector<ShippedScene> ${list}() {\n  return {\n${entries}  };\n}\n")
  set(definitions "${definitions}" PARENT_SCOPE)
endfunction()
embed_files(example_scenes "${FIXTURES}/scenes/*.toml")

# The function `name` returns the scripts that FOLDER/scripts.txt lists, joined; without their margin
# and the comments that have a line of their own or stand at the end of one.
function(embed_scripts name folder)
  file(STRINGS "${folder}/scripts.txt" files)
  set(script "")
  foreach(file IN LISTS files)
    file(READ "${folder}/${file}" part)
    string(APPEND script "${part}\n")
  endforeach()
  without_margin(script "\n${script}")
  string(REGEX REPLACE "\n//[^\n]*" "" script "${script}")
  string(REGEX REPLACE "([;,{})]) +// [^\n\"'`]*\n" "\\1\n" script "${script}")
  string(REGEX REPLACE "\n\n+" "\n" script "${script}")
  # A page has a limit, and there are hundreds.
  string(REPLACE " {\n" " {" script "${script}")
  string(REPLACE ") {" "){" script "${script}")
  foreach(sign IN ITEMS => === !== && || += -= < <= >= * ?) # no text has these between blanks
    string(REPLACE " ${sign} " "${sign}" script "${script}")
  endforeach()
  string(REGEX REPLACE "(const|let) ([A-Za-z_]+) = " "\\1 \\2=" script "${script}")
  string(REGEX REPLACE "(if|for|while) \\(" "\\1(" script "${script}")
  string(REPLACE "{ " "{" script "${script}")
  string(REPLACE " }" "}" script "${script}")
  string(REPLACE ";\n}" "}" script "${script}") # what ends a block needs no sign of its own
  string(REPLACE "}\n}" "}}" script "${script}")
  embed(${name} "${script}")
  set(definitions "${definitions}" PARENT_SCOPE)
endfunction()
embed_scripts(drawing_script "${SOURCES}/draw/script")
embed_scripts(explorer_script "${SOURCES}/pivots/explorer")
embed_scripts(play_script "${SOURCES}/play/page")

file(WRITE "${OUTPUT}"
     "// Made by src/cmake/embed_text.cmake; not to be edited.\n"
     "#include \"draw/markup.hpp\"\n#include \"export/export_parts.hpp\"\n"
     "#include \"pivots/explorer.hpp\"\n"
     "#include \"play/page_text.hpp\"\n"
     "#include \"scenes/shipped_scenes.hpp\"\n\n"
     "namespace lcpush::desktop {\n${definitions}} // namespace lcpush::desktop\n")
