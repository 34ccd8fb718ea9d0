# The core on microcontrollers: cross-built for three of them, run under QEMU, and gated. Debian:
# gcc-arm-none-eabi libnewlib-dev libstdc++-arm-none-eabi-dev qemu-system-arm, and for the bundle what
# docs/building.md lists. Nothing of a C or C++ library is linked, only libgcc.
find_program(LCPUSH_ARM_CC arm-none-eabi-gcc REQUIRED)
find_program(LCPUSH_ARM_CXX arm-none-eabi-g++ REQUIRED)
find_program(LCPUSH_ARM_QEMU qemu-system-arm REQUIRED)
foreach(program IN ITEMS riscv64-unknown-elf-g++ qemu-system-riscv32 clang++ wasm-ld-14 node)
  find_program(LCPUSH_HAS_${program} ${program} REQUIRED) # for bundle.py
endforeach()
if(NOT Python3_FOUND)
  message(FATAL_ERROR "LCPUSH_FIRMWARE_TESTS needs python3 >= 3.11")
endif()

set(firmware ${CMAKE_CURRENT_SOURCE_DIR}/firmware)
set(firmware_build ${CMAKE_CURRENT_BINARY_DIR}/firmware)
file(MAKE_DIRECTORY ${firmware_build})
set(firmware_files "")

# Single precision without and with an FPU, and double in hardware.
set(firmware_m3_cpu -mcpu=cortex-m3 -mfloat-abi=soft)
set(firmware_m4f_cpu -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard)
set(firmware_m7d_cpu -mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard)
set(firmware_m7d_precision -DFIRMWARE_DOUBLE)

# Both change the order of sums, and so the bits: the desktop's programs have them too.
set(firmware_eigen -DEIGEN_DONT_VECTORIZE -DEIGEN_UNROLLING_LIMIT=0)

set(firmware_flags
    -mthumb -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -fstack-usage
    -Wall -Wextra -Wdouble-promotion -DNDEBUG -DEIGEN_NO_IO ${firmware_eigen}
    -I${PROJECT_SOURCE_DIR}/include -I${PROJECT_BINARY_DIR}/include -I${PROJECT_SOURCE_DIR}/src
    -I${firmware} -isystem ${eigen_include})
if(LCPUSH_WARNINGS_AS_ERRORS)
  list(APPEND firmware_flags -Werror)
endif()
set(firmware_flags_c -std=c99)
set(firmware_flags_cxx -std=c++17 -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-unwind-tables
                       -fno-asynchronous-unwind-tables)

# `name`.`target`.o from a source; more flags may follow.
function(firmware_object name target source)
  set(object ${firmware_build}/${name}.${target}.o)
  if(source MATCHES "\\.c$")
    set(compile ${LCPUSH_ARM_CC} ${firmware_flags_c})
  else()
    set(compile ${LCPUSH_ARM_CXX} ${firmware_flags_cxx})
  endif()
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${compile} ${firmware_${target}_cpu} ${firmware_${target}_precision} -Os
            ${firmware_flags} ${ARGN} -MD -MT ${object} -MF ${object}.d -c ${source} -o ${object}
    DEPENDS ${source} DEPFILE ${object}.d VERBATIM)
endfunction()

# `name`.`target`.elf and its map from objects and linker flags.
function(firmware_program name target)
  set(elf ${firmware_build}/${name}.${target}.elf)
  set(objects "")
  set(flags "")
  foreach(argument IN LISTS ARGN)
    if(argument MATCHES "^-")
      list(APPEND flags ${argument})
    else()
      list(APPEND objects ${firmware_build}/${argument}.${target}.o)
    endif()
  endforeach()
  foreach(common IN ITEMS text device runtime)
    list(APPEND objects ${firmware_build}/${common}.${target}.o)
  endforeach()
  add_custom_command(
    OUTPUT ${elf}
    COMMAND ${LCPUSH_ARM_CC} -mthumb ${firmware_${target}_cpu} -nostdlib -T ${firmware}/mps2.ld
            -Wl,--gc-sections -Wl,--no-warn-rwx-segments -Wl,-Map=${elf}.map ${flags} ${objects}
            -lgcc -o ${elf}
    DEPENDS ${objects} ${firmware}/mps2.ld VERBATIM)
  set(firmware_files ${firmware_files} ${elf} PARENT_SCOPE)
endfunction()

foreach(target IN ITEMS m3 m4f m7d)
  firmware_object(core ${target} ${PROJECT_SOURCE_DIR}/src/c/c_interface.cpp)
  foreach(name IN ITEMS push sizes small loop hold work text device)
    firmware_object(${name} ${target} ${firmware}/${name}.c)
  endforeach()
  # Or gcc makes memset of the loop in memset.
  firmware_object(runtime ${target} ${firmware}/runtime.c -fno-builtin
                  -fno-tree-loop-distribute-patterns)
  foreach(name IN ITEMS pivots kernel kernel_main)
    firmware_object(${name} ${target} ${firmware}/${name}.cpp)
  endforeach()
  firmware_program(push ${target} push core)
  firmware_program(sizes ${target} sizes core)
  firmware_program(small ${target} small core)
  firmware_object(core_flto ${target} ${PROJECT_SOURCE_DIR}/src/c/c_interface.cpp -flto)
  firmware_program(small_flto ${target} small core_flto -flto=auto)
  foreach(part IN ITEMS break motion hold sweeps)
    string(TOUPPER ${part} with)
    firmware_object(small_${part} ${target} ${firmware}/small.c -D${with})
    firmware_program(small_${part} ${target} small_${part} core)
  endforeach()
  firmware_program(loop ${target} loop core)
  firmware_program(hold ${target} hold core)
  firmware_program(work ${target} work core)
  firmware_program(pivots ${target} pivots)
  firmware_program(kernel ${target} kernel kernel_main)
endforeach()

# What each gate must catch: a program with one fault, of a function that stands before the real one.
foreach(planted IN ITEMS heap:lcpushf_solve double:lcpushf_contact_at data:lcpushf_solve
                         ram:lcpushf_solve work:lcpushf_solve stack:lcpushf_solve
                         bit:lcpushf_contact_at limit:lcpushf_limit late:lcpushf_limit)
  string(REPLACE ":" ";" planted ${planted})
  list(GET planted 0 name)
  list(GET planted 1 function)
  firmware_object(planted_${name} m4f ${firmware}/planted/${name}.cpp)
  firmware_program(planted_${name} m4f push planted_${name} core -Wl,--wrap=${function})
endforeach()
firmware_object(planted_carries m4f ${firmware}/planted/carries.cpp)
firmware_program(planted_carries m4f small planted_carries core -Wl,--wrap=lcpushf_contact_at)
firmware_object(planted_path m4f ${firmware}/planted/path.cpp)
firmware_program(planted_path m4f pivots planted_path -Wl,--wrap=hash_bits)
firmware_object(planted_turn m4f ${firmware}/planted/turn.cpp)
firmware_program(planted_turn m4f kernel planted_turn kernel_main
                 -Wl,--wrap=_Z4turnRN6lcpush10DictionaryIfiEEiPfPi)
firmware_object(planted_kernel m4f ${firmware}/kernel.cpp -O3 -funroll-loops)
firmware_program(planted_kernel m4f planted_kernel kernel_main)

add_custom_target(firmware ALL DEPENDS ${firmware_files})
add_dependencies(firmware device_bundle)

# The same programs here, for the bits that the boards must give.
function(firmware_on_desktop name precision)
  add_executable(firmware_${name}_${precision} ${ARGN} ${firmware}/text.c ${firmware}/desktop.c)
  lcpush_compile_options(firmware_${name}_${precision})
  target_compile_definitions(firmware_${name}_${precision} PRIVATE ${firmware_eigen})
  if(precision STREQUAL "double")
    target_compile_definitions(firmware_${name}_${precision} PRIVATE FIRMWARE_DOUBLE)
  endif()
  target_include_directories(firmware_${name}_${precision} PRIVATE ${firmware})
  target_link_libraries(firmware_${name}_${precision} PRIVATE lcpush::lcpush)
  set_target_properties(firmware_${name}_${precision} PROPERTIES
    LINKER_LANGUAGE CXX C_STANDARD 99 RUNTIME_OUTPUT_DIRECTORY ${firmware_build})
endfunction()
add_library(firmware_core OBJECT ${PROJECT_SOURCE_DIR}/src/c/c_interface.cpp)
lcpush_compile_options(firmware_core)
target_compile_definitions(firmware_core PRIVATE ${firmware_eigen})
target_link_libraries(firmware_core PRIVATE lcpush::lcpush)
foreach(precision IN ITEMS float double)
  firmware_on_desktop(push ${precision} ${firmware}/push.c $<TARGET_OBJECTS:firmware_core>)
  firmware_on_desktop(sizes ${precision} ${firmware}/sizes.c $<TARGET_OBJECTS:firmware_core>)
  firmware_on_desktop(small ${precision} ${firmware}/small.c $<TARGET_OBJECTS:firmware_core>)
  firmware_on_desktop(loop ${precision} ${firmware}/loop.c $<TARGET_OBJECTS:firmware_core>)
  firmware_on_desktop(hold ${precision} ${firmware}/hold.c $<TARGET_OBJECTS:firmware_core>)
  firmware_on_desktop(work ${precision} ${firmware}/work.c $<TARGET_OBJECTS:firmware_core>)
  firmware_on_desktop(pivots ${precision} ${firmware}/pivots.cpp)
  firmware_on_desktop(kernel ${precision} ${firmware}/kernel.cpp ${firmware}/kernel_main.cpp)
endforeach()

set(firmware_gates Python3::Interpreter ${firmware}/gates.py --build ${firmware_build} --qemu
                   ${LCPUSH_ARM_QEMU})
foreach(target IN ITEMS m3 m4f m7d)
  add_test(NAME firmware.${target} COMMAND ${firmware_gates} ${target})
endforeach()
add_test(NAME firmware.planted_failures COMMAND ${firmware_gates} planted)
if(TARGET lcpush_tool)
  add_test(NAME firmware.scenes COMMAND ${firmware_gates} --tool $<TARGET_FILE:lcpush_tool>
                                        --fixtures ${PROJECT_SOURCE_DIR}/fixtures/scenes scenes)
endif()

# The folder that somebody copies, compiled by others' compilers as its README says.
set(firmware_bundle
    Python3::Interpreter -B ${firmware}/bundle.py --build ${firmware_build} --sources ${PROJECT_SOURCE_DIR}
    --eigen ${eigen_include} --compiler ${CMAKE_CXX_COMPILER} --cmake ${CMAKE_COMMAND} --version
    ${PROJECT_VERSION} --target-made ${PROJECT_BINARY_DIR}/device_bundle)
add_test(NAME firmware.bundle COMMAND ${firmware_bundle} bundle)
add_test(NAME firmware.bundle_planted COMMAND ${firmware_bundle} planted)
add_test(NAME firmware.hundred COMMAND ${firmware_bundle} hundred)
# They share what they compile.
set_tests_properties(firmware.bundle firmware.hundred PROPERTIES PROCESSORS 2)
set_tests_properties(firmware.hundred firmware.bundle_planted PROPERTIES DEPENDS firmware.bundle)
set_tests_properties(firmware.bundle firmware.hundred firmware.bundle_planted
                     PROPERTIES RESOURCE_LOCK device_bundle)
