# ruff: noqa: E501 - a case is a line
"""Each edit of a CMakeLists.txt: what it makes of a file, and that its inverse takes it back."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from plastron_tui.sources.build_files import Edited
from plastron_tui.sources.cmake import dependencies, interfaces, programs, shares

PATH = Path("CMakeLists.txt")
AMENT = """\
cmake_minimum_required(VERSION 3.8)
project(rover)

find_package(ament_cmake REQUIRED)
{}
ament_package()
"""
CATKIN = """\
cmake_minimum_required(VERSION 3.0.2)
project(rover)
find_package(catkin REQUIRED COMPONENTS rospy)
{}
"""
BARE = "cmake_minimum_required(VERSION 3.0.2)\nproject(rover)\n{}\ncatkin_package()\n"

Edit = Callable[[bytes, Path, str], Edited]
EDITS: dict[str, tuple[Edit, Edit]] = {
    "program": (programs.add_program, programs.remove_program),
    "dependency": (dependencies.add_dependency, dependencies.remove_dependency),
    "exported": (dependencies.add_exported, dependencies.remove_exported),
    "shared": (shares.add_shared, shares.remove_shared),
    "interface": (interfaces.add_interface, interfaces.remove_interface),
    "interface dependency": (
        interfaces.add_interface_dependency,
        interfaces.remove_interface_dependency,
    ),
}

# What is done, to which file, before, after; `<` and `>` stand around what is new.
CASES = [
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py< scripts/b.py> DESTINATION lib/${PROJECT_NAME})"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS\n  scripts/a.py # first\n<  scripts/b.py\n>  DESTINATION lib/rover)"),
    ("program scripts/b.py", AMENT, "Set(x scripts/a.py\n\tscripts/c.py<\n\tscripts/b.py>)\ninstall(PROGRAMS ${x}\n  DESTINATION lib/${PROJECT_NAME})".replace("c.py", "A.py")),
    ("program scripts/b.py", AMENT, "set(x scripts/a.py)\nlist(APPEND x scripts/z.py< scripts/b.py>)\ninstall(PROGRAMS ${x} DESTINATION lib/rover)".replace("z.py", "A.py")),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py DESTINATION bin)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "\n<install(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n\n># tests\nif(BUILD_TESTING)\n  foo()\nendif()"),
    ("program scripts/b.py", AMENT, "if(X)\n  install(PROGRAMS scripts/b.py DESTINATION lib/rover)\nendif()\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "foreach(x a b)\n  install(PROGRAMS scripts/${x}.py DESTINATION lib/rover)\nendforeach()"),
    ("program scripts/b.py", AMENT, "file(GLOB x scripts/*.py)\ninstall(PROGRAMS ${x} DESTINATION lib/rover)"),
    ("program scripts/b.py", CATKIN, "CATKIN_INSTALL_PYTHON(PROGRAMS scripts/a.py< scripts/b.py> DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})"),
    ("program scripts/b.py", CATKIN, "catkin_package()\n<\ncatkin_install_python(PROGRAMS\n  scripts/b.py\n  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}\n)\n>"),
    ("program scripts/b", CATKIN, "catkin_package()\n<\ninstall(PROGRAMS\n  scripts/b\n  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}\n)\n>"),
    ("program scripts/b.py", CATKIN, "INSTALL(TARGETS x\n        DESTINATION y)\nSET(A B)\nSET(C D)\nSET(E F)\n".replace("        DESTINATION y)\n", "        DESTINATION y)\n<\nCATKIN_INSTALL_PYTHON(PROGRAMS\n        scripts/b.py\n        DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n>")),
    ("program scripts/b.py", CATKIN, "add_rostest(x)\ncatkin_package()\n<\ncatkin_install_python(PROGRAMS\n  scripts/b.py\n  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}\n)\n>"),
    ("program scripts/b.py", CATKIN, "install(TARGETS x DESTINATION lib)\ncatkin_package()\n<\ncatkin_install_python(PROGRAMS\n  scripts/b.py\n  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}\n)\n>add_library(y z)"),
    ("shared launch/x.launch", CATKIN, "catkin_add_gtest(x y)\ncatkin_package()\n<\ninstall(DIRECTORY\n  launch\n  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}\n)\n>"),
    ("dependency std_msgs", AMENT, "find_package(rclpy REQUIRED) # client library\n<find_package(std_msgs REQUIRED)\n>"),
    ("dependency std_msgs", AMENT, "find_package(rclpy REQUIRED)\n<find_package(std_msgs REQUIRED)\n>find_package(tf2 REQUIRED)"),
    ("dependency std_msgs", AMENT, "foreach(x rclpy std_msgs)\n  find_package(${x} REQUIRED)\nendforeach()"),
    ("dependency std_msgs", AMENT, "find_package(ament_cmake_auto)\nament_auto_find_build_dependencies()"),
    ("dependency std_msgs", AMENT, "if(X)\n  find_package(std_msgs REQUIRED)\nendif()\nfind_package(rclpy)\n<find_package(std_msgs REQUIRED)\n>"),
    ("dependency std_msgs", BARE, "find_package(catkin REQUIRED roscpp< std_msgs> tf)"),
    ("dependency std_msgs", BARE, "find_package(catkin REQUIRED std_msgs roscpp)"),
    ("dependency std_msgs", BARE, "find_package(catkin REQUIRED tf COMPONENTS roscpp std_msgs)"),
    ("exported std_msgs", CATKIN, "catkin_package(<CATKIN_DEPENDS std_msgs>)"),
    ("exported std_msgs", CATKIN, "catkin_package(CATKIN_DEPENDS<\n  std_msgs>)"),
    ("exported std_msgs", CATKIN, "catkin_package(\n  CATKIN_DEPENDS\n  roscpp\n<  std_msgs\n>  DEPENDS eigen\n)"),
    ("shared launch/x.launch", AMENT, "install(DIRECTORY\n  config\n<  launch\n>  DESTINATION share/${PROJECT_NAME})"),
    ("shared launch/x.launch", AMENT, "install(DIRECTORY config launch DESTINATION share/rover)"),
    ("shared launch/x.launch", AMENT, "install(DIRECTORY launch/ DESTINATION share/${PROJECT_NAME}/launch)"),
    ("shared launch/x.launch", AMENT, "install(FILES launch/x.launch DESTINATION share/rover/launch)"),
    ("shared launch/x.launch", AMENT, 'install(DIRECTORY launch DESTINATION share/rover FILES_MATCHING PATTERN "*.launch")'),
    ("shared launch/x.launch", CATKIN, "catkin_package()\n<\ninstall(DIRECTORY\n  launch\n  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}\n)\n>"),
    ("interface msg/B.msg", AMENT, 'rosidl_generate_interfaces(${PROJECT_NAME}\n  "msg/A.msg"\n<  "msg/B.msg"\n>  DEPENDENCIES std_msgs)'),
    ("interface msg/B.msg", AMENT, 'set(x\n  msg/A.msg\n<  msg/B.msg\n>)\nrosidl_generate_interfaces(rover ${x})'),
    ("interface msg/B.msg", AMENT, "file(GLOB x RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)\nrosidl_generate_interfaces(rover ${x})"),
    ("interface srv/B.srv", CATKIN, "add_message_files(FILES A.msg)\n<\nadd_service_files(FILES\n  B.srv\n)\n>\ncatkin_package()"),
    ("interface msg/B.msg", CATKIN, "add_message_files(\n  FILES\n  A.msg\n<  B.msg\n>)"),
    ("interface msg/B.msg", CATKIN, "add_message_files(FILES<\n  B.msg> # none\n)"),
    ("interface dependency std_msgs", AMENT, 'rosidl_generate_interfaces(${PROJECT_NAME}\n  "msg/A.msg"\n<  DEPENDENCIES std_msgs\n>)'),
    ("interface dependency std_msgs", CATKIN, "generate_messages(DEPENDENCIES geometry_msgs< std_msgs>)"),
    ("interface dependency std_msgs", CATKIN, "\n<generate_messages(DEPENDENCIES\n  std_msgs\n)\n\n>catkin_package()"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py DESTINATION lib/rover CONFIGURATIONS Debug)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/b.py DESTINATION lib/rover CONFIGURATIONS Debug)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py DESTINATION lib/rover EXCLUDE_FROM_ALL)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/b.py DESTINATION lib/rover EXCLUDE_FROM_ALL)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py DESTINATION lib/rover PERMISSIONS OWNER_READ)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/b.py DESTINATION lib/rover PERMISSIONS OWNER_READ OWNER_WRITE)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py DESTINATION lib/rover OPTIONAL)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py DESTINATION lib/rover RENAME a)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/b.py DESTINATION lib/rover RENAME b)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/b.py DESTINATION lib/rover PERMISSIONS OWNER_READ OWNER_EXECUTE)"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/b.py DESTINATION lib/rover RENAME b.py)"),
    ("program scripts/b.py", AMENT, "install(PROGRAMS scripts/a.py< scripts/b.py> DESTINATION lib/rover COMPONENT nodes)"),
    ("program scripts/b.py", AMENT, "set(x scripts/z.py scripts/A.py)\nforeach(s IN LISTS x)\n  configure_file(${s} ${s})\nendforeach()\ninstall(PROGRAMS ${x} DESTINATION lib/rover)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "set(x scripts/z.py scripts/A.py)\nlist(LENGTH x n)\ninstall(PROGRAMS ${x} DESTINATION lib/rover)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "set(x scripts/z.py scripts/A.py)\nif(x)\n  message(a)\nendif()\ninstall(PROGRAMS ${x} DESTINATION lib/rover)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "set(x scripts/z.py scripts/A.py)\nset(y ${x})\ninstall(PROGRAMS ${x} DESTINATION lib/rover)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "set(x scripts/z.py scripts/A.py)\nfunction(f)\n  list(GET x 0 y)\nendfunction()\ninstall(PROGRAMS ${x} DESTINATION lib/rover)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("program scripts/b.py", AMENT, "if(X)\n  set(x scripts/a.py)\nendif()\ninstall(PROGRAMS ${x} DESTINATION lib/rover)\n<\ninstall(PROGRAMS\n  scripts/b.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n>"),
    ("shared x.launch", AMENT, "\n<install(FILES\n  x.launch\n  DESTINATION share/${PROJECT_NAME}\n)\n\n>ament_export_x(y)"),
    ("shared x.launch", AMENT, "install(FILES plugin.xml< x.launch> DESTINATION share/rover)"),
    ("shared x.launch", AMENT, "install(FILES x.launch DESTINATION share/rover)"),
    ("shared x.launch", AMENT, "install(FILES plugin.xml DESTINATION share/rover RENAME y.xml)\n<\ninstall(FILES\n  x.launch\n  DESTINATION share/${PROJECT_NAME}\n)\n>"),
    ("shared launch/a/x.launch", AMENT, "install(DIRECTORY\n  config\n<  launch\n>  DESTINATION share/${PROJECT_NAME})"),
    ("shared launch/x.launch", AMENT, "install(DIRECTORY config DESTINATION share/rover CONFIGURATIONS Debug)\n<\ninstall(DIRECTORY\n  launch\n  DESTINATION share/${PROJECT_NAME}\n)\n>"),
]  # fmt: skip
"""Cases without a mark are those in which there is nothing to do."""


def edits_of(what: str) -> tuple[Edit, Edit, str]:
    name, _, value = what.rpartition(" ")
    return (*EDITS[name], value)


def texts_of(form: str, marked: str) -> tuple[bytes, bytes]:
    before = "".join(part.split(">")[-1] for part in marked.split("<"))
    after = marked.replace("<", "").replace(">", "")
    return form.format(before).encode(), form.format(after).encode()


@pytest.mark.parametrize("ending", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize(("what", "form", "marked"), CASES)
def test_an_edit_and_its_inverse(what: str, form: str, marked: str, ending: str) -> None:
    add, remove, value = edits_of(what)
    before, after = (each.replace(b"\n", ending.encode()) for each in texts_of(form, marked))
    edited = add(before, PATH, value)
    assert edited.diagnostics == ()
    assert (edited.text or b"").decode() == after.decode()
    if before != after:
        assert remove(after, PATH, value) == (before, ())
        assert add(after, PATH, value) == (after, ())
