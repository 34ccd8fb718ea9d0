# Turns the explorer's files and its start example into one C++ file of functions, so that the tool
# carries its page with it. Run by `cmake -DFOLDER=.. -DEXAMPLE=.. -DOUTPUT=.. -P embed_text.cmake`.
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
    string(APPEND pieces "  text += R\"explorer(${piece})explorer\";\n")
  endwhile()
  set(${variable} "${pieces}" PARENT_SCOPE)
endfunction()

function(definition variable name text)
  literals(pieces "${text}")
  set(${variable} "std::string ${name}() {\n  std::string text;\n${pieces}  return text;\n}\n"
      PARENT_SCOPE)
endfunction()

file(READ "${FOLDER}/explorer.html" page)
file(READ "${FOLDER}/explorer.css" style)
file(STRINGS "${FOLDER}/scripts.txt" names)
set(script "")
foreach(name IN LISTS names)
  file(READ "${FOLDER}/${name}" part)
  string(APPEND script "${part}\n")
endforeach()

file(READ "${EXAMPLE}" example)
definition(example_function example_scene "${example}")
definition(page_function explorer_template "${page}")
definition(style_function explorer_style "${style}")
definition(script_function explorer_script "${script}")
file(WRITE "${OUTPUT}"
     "// Made by src/cmake/embed_text.cmake from src/pivots/explorer; not to be edited.\n"
     "#include \"pivots/explorer_text.hpp\"\n\nnamespace lcpush::desktop {\n"
     "${page_function}${style_function}${script_function}${example_function}"
     "} // namespace lcpush::desktop\n")
