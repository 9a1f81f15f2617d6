# lapidary_module(NAME SOURCES... [PUBLIC libs...] [PRIVATE libs...]): one static library per
# folder of src/, called lapidary_NAME, included as "NAME/header.h".
function(lapidary_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(lapidary_${name} STATIC ${ARG_SOURCES})
  target_include_directories(lapidary_${name} PUBLIC "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(lapidary_${name} PUBLIC lapidary_flags ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# lapidary_test(NAME SOURCES... [LIBS libs...]): one GoogleTest program per folder of tests/; every
# case is a ctest test of its own.
function(lapidary_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_include_directories(test_${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}")
  target_link_libraries(test_${name} PRIVATE ${ARG_LIBS} GTest::gtest_main)
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60)
endfunction()
