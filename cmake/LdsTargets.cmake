# The kinds of target this project has. A library exposes its own folder and nothing else, so headers
# are included by file name ("setting_item.h") and an include of a folder that LINKS does not name does
# not compile. That is how the layers of docs/architecture.md hold.

add_library(lds_options INTERFACE)
target_compile_options(lds_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Werror)
target_compile_definitions(lds_options INTERFACE
    QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_KEYWORDS QT_NO_FOREACH
    LDS_VERSION="${PROJECT_VERSION}")
if(LDS_SANITIZE)
    target_compile_options(lds_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
    target_link_options(lds_options INTERFACE -fsanitize=address,undefined)
endif()

# LDS_LIBFUZZER (clang only) is for a build folder of its own, of which only the fuzz targets are built:
# libFuzzer drives them, with the code under test instrumented and both sanitizers on.
option(LDS_LIBFUZZER "Let libFuzzer drive the fuzz targets (needs clang)" OFF)
if(LDS_LIBFUZZER)
    target_compile_options(lds_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
        -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(lds_options INTERFACE -fsanitize=address,undefined)
endif()

# lds_library(NAME [SOURCES file...] [HEADERS file...] [LINKS target...])
# The library lds_NAME of the current folder. HEADERS need to be named only when they hold a Q_OBJECT
# and no SOURCES file of the same name. Without SOURCES the library is header only.
function(lds_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;LINKS" ${ARGN})
    if(ARG_SOURCES)
        add_library(lds_${name} STATIC ${ARG_SOURCES} ${ARG_HEADERS})
        set(scope PUBLIC)
    else()
        add_library(lds_${name} INTERFACE)
        set(scope INTERFACE)
    endif()
    target_link_libraries(lds_${name} ${scope} ${ARG_LINKS} lds_options)
    target_include_directories(lds_${name} ${scope} ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()

# lds_program(NAME SOURCES file... LINKS target...): a program in <build>/bin.
function(lds_program name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE ${ARG_LINKS} lds_options)
    target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()

# lds_test(NAME LABEL unit|flow|interop [SOURCES file...] [LINKS target...] [TIMEOUT seconds])
# A Qt Test program; SOURCES defaults to NAME.cpp. Tests run offscreen, in the C locale, and find the
# programs of this build in LDS_BIN.
function(lds_test name)
    cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LINKS" ${ARGN})
    if(NOT ARG_SOURCES)
        set(ARG_SOURCES ${name}.cpp)
    endif()
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 120)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE ${ARG_LINKS} Qt6::Test lds_options)
    target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT}
        ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8;LANGUAGE=en;LDS_BIN=${CMAKE_BINARY_DIR}/bin;LDS_SOURCE=${CMAKE_SOURCE_DIR}")
endfunction()

# lds_bench(NAME [SOURCES file...] [LINKS target...]): built only with LDS_BUILD_BENCHES; run by scripts/bench.
function(lds_bench name)
    if(NOT LDS_BUILD_BENCHES)
        return()
    endif()
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
    if(NOT ARG_SOURCES)
        set(ARG_SOURCES ${name}.cpp)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE ${ARG_LINKS} lds_options)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS bench TIMEOUT 600
        ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8")
endfunction()

# lds_fuzz(NAME CORPUS folder [SOURCES file...] [LINKS target...] [RUNS n])
# A fuzz target: SOURCES (NAME.cpp by default) define LLVMFuzzerTestOneInput, CORPUS is its folder of seeds.
# As a test it takes every seed and RUNS deterministic changes of seeds; the default is about 20 seconds'
# worth with sanitizers, where it counts, and 3 seconds' in a release build. LDS_FUZZ_RUNS in the environment
# replaces RUNS: 3500000 make a minute. With LDS_LIBFUZZER the test is one minute of libFuzzer instead.
function(lds_fuzz name)
    cmake_parse_arguments(ARG "" "CORPUS;RUNS" "SOURCES;LINKS" ${ARGN})
    if(NOT ARG_SOURCES)
        set(ARG_SOURCES ${name}.cpp)
    endif()
    if(NOT ARG_RUNS)
        set(ARG_RUNS 1200000)
    endif()
    set(corpus ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_CORPUS})
    add_executable(${name} ${ARG_SOURCES} allocation_watch.cpp)
    target_link_libraries(${name} PRIVATE ${ARG_LINKS} lds_options)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    if(LDS_LIBFUZZER)
        target_link_options(${name} PRIVATE -fsanitize=fuzzer)
        set(found ${CMAKE_CURRENT_BINARY_DIR}/${name}_found)
        file(MAKE_DIRECTORY ${found})
        add_test(NAME ${name} COMMAND ${name} -max_total_time=60 -max_len=2048 ${found} ${corpus})
    else()
        target_sources(${name} PRIVATE fuzz_main.cpp)
        add_test(NAME ${name} COMMAND ${name} --runs ${ARG_RUNS} ${corpus})
    endif()
    set_tests_properties(${name} PROPERTIES LABELS fuzz TIMEOUT 600)
endfunction()
