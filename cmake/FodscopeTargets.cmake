# The layers of Fodscope are CMake targets. A layer sees only what it is linked with, so a forbidden
# dependency fails to compile or link instead of waiting for a reviewer.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(fodscope_options INTERFACE)
target_include_directories(fodscope_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(fodscope_options INTERFACE -Wall -Wextra
    $<$<BOOL:${FODSCOPE_WARNINGS_AS_ERRORS}>:-Werror>
    # The same input must give the same numbers on every machine: no contraction into fused operations.
    -ffp-contract=off)

# fodscope_add_library(NAME SOURCES file... DEPENDS target...)
# makes the static library fodscope_NAME with the alias fodscope::NAME.
function(fodscope_add_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    add_library(fodscope_${name} STATIC ${ARG_SOURCES})
    add_library(fodscope::${name} ALIAS fodscope_${name})
    target_link_libraries(fodscope_${name} PUBLIC fodscope_options ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
endfunction()

# fodscope_add_test(NAME SOURCES file... DEPENDS target... [LABELS label...] [TIMEOUT seconds])
# makes one GoogleTest program and registers it with ctest.
function(fodscope_add_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;DEPENDS;LABELS" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 120)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE fodscope_options ${ARG_DEPENDS} GTest::gtest GTest::gmock GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE
        FODSCOPE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
        FODSCOPE_RESOURCES="${PROJECT_SOURCE_DIR}/resources")
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# fodscope_add_ui_test(NAME SOURCES file... DEPENDS target... [LABELS label...] [TIMEOUT seconds])
# makes one GoogleTest program whose main() holds the QApplication, as the workstation sets it up.
# The tests redirect HOME so that no setting of the user is read or written.
function(fodscope_add_ui_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;DEPENDS;LABELS" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 120)
    endif()
    add_executable(${name} ${ARG_SOURCES} ${PROJECT_SOURCE_DIR}/tests/ui/UiTestMain.cpp)
    target_link_libraries(${name} PRIVATE fodscope_options ${ARG_DEPENDS} fodscope::theme Qt5::Test GTest::gtest GTest::gmock)
    target_compile_definitions(${name} PRIVATE
        FODSCOPE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
        FODSCOPE_RESOURCES="${PROJECT_SOURCE_DIR}/resources")
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "ui;${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
