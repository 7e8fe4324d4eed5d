# ROS 1 as Debian packages it, for the bridge and the robot simulator. Everything else builds without it.
# It is found through pkg-config: ROS's own CMake files start catkin, which runs whatever python3 comes first on the
# PATH and fails where that one lacks catkin_pkg.
option(FODSCOPE_ROS1 "Build the ROS 1 programs where ROS 1 is found" ON)

set(FODSCOPE_ROS1_FOUND FALSE)
if(FODSCOPE_ROS1)
    pkg_check_modules(ROS1 IMPORTED_TARGET
        roscpp actionlib actionlib_msgs geometry_msgs map_msgs move_base_msgs nav_msgs sensor_msgs std_msgs std_srvs
        tf2_msgs tf2_ros)
    # rosbag_storage.pc asks for a pluginlib.pc that no package has, and rosbag/bag.h includes what Debian keeps in
    # folders of ROS 2's packages.
    find_path(ROSBAG_INCLUDE_DIR rosbag/bag.h)
    foreach(package pluginlib class_loader rcpputils rcutils ament_index_cpp)
        find_path(ROSBAG_${package}_DIR NAMES ${package} PATHS /usr/include PATH_SUFFIXES ${package} NO_DEFAULT_PATH)
        if(ROSBAG_${package}_DIR)
            list(APPEND ROSBAG_PACKAGE_DIRS ${ROSBAG_${package}_DIR})
        endif()
    endforeach()
    find_library(ROSBAG_LIBRARY rosbag_storage)
    find_library(CONSOLE_BRIDGE_LIBRARY console_bridge)
endif()
if(ROS1_FOUND AND ROSBAG_INCLUDE_DIR AND ROSBAG_LIBRARY AND CONSOLE_BRIDGE_LIBRARY)
    set(FODSCOPE_ROS1_FOUND TRUE)
    add_library(fodscope_rosbag INTERFACE)
    target_include_directories(fodscope_rosbag SYSTEM INTERFACE ${ROSBAG_INCLUDE_DIR} ${ROSBAG_PACKAGE_DIRS})
    target_link_libraries(fodscope_rosbag INTERFACE ${ROSBAG_LIBRARY} ${CONSOLE_BRIDGE_LIBRARY} PkgConfig::ROS1)
    add_library(fodscope::rosbag ALIAS fodscope_rosbag)
endif()

if(NOT FODSCOPE_ROS1_FOUND)
    message(STATUS "ROS 1 was not found: fodscope-ros1-bridge and fodscope-robot-simulator are not built")
endif()

# fodscope_add_ros1_library(NAME SOURCES file... DEPENDS target... PRIVATE_DEPENDS target...)
# makes the static library fodscope_NAME with the alias fodscope::NAME from files that include ROS headers. These do not
# compile as C++20 (std::allocator<void>::rebind), so such files are C++17; the header that the rest of the program sees
# is clean C++17 and includes no ROS header. Bags come with PRIVATE_DEPENDS
# fodscope::rosbag.
function(fodscope_add_ros1_library name)
    fodscope_add_library(${name} ${ARGN})
    target_link_libraries(fodscope_${name} PRIVATE PkgConfig::ROS1)
    set_target_properties(fodscope_${name} PROPERTIES CXX_STANDARD 17)
endfunction()
