# SPDX-License-Identifier: GPL-3.0-or-later
# Qt for the window: the version VTK was built with, since both must be the same. With
# KAMBARA_QT_VERSION the other one, then without the 3-D view where VTK does not fit.
set(KAMBARA_QT_VERSION "" CACHE STRING "Qt to build the window with: 5, 6, or empty for VTK's")

set(KAMBARA_VTK_COMPONENTS CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath
    CommonTransforms FiltersSources GUISupportQt IOImage InteractionStyle RenderingCore
    RenderingFreeType RenderingOpenGL2)
set(KAMBARA_SCENE3D OFF)
if(NOT KAMBARA_QT_VERSION STREQUAL "6")
    find_package(VTK 9.1 QUIET COMPONENTS ${KAMBARA_VTK_COMPONENTS})
    if(VTK_FOUND AND (KAMBARA_QT_VERSION STREQUAL "" OR KAMBARA_QT_VERSION STREQUAL VTK_QT_VERSION))
        set(KAMBARA_SCENE3D ON)
    endif()
endif()
if(NOT KAMBARA_QT_VERSION STREQUAL "")
    set(KAMBARA_QT ${KAMBARA_QT_VERSION})
elseif(KAMBARA_SCENE3D)
    set(KAMBARA_QT ${VTK_QT_VERSION})
else()
    set(KAMBARA_QT 5)
endif()
find_package(Qt${KAMBARA_QT} REQUIRED COMPONENTS Core Gui Widgets PrintSupport LinguistTools)
if(KAMBARA_TESTS)
    find_package(Qt${KAMBARA_QT} REQUIRED COMPONENTS Test)
endif()
set(KAMBARA_QT_TARGET Qt${KAMBARA_QT}::)
if(KAMBARA_QT EQUAL 6)
    find_package(QCustomPlotQt6 REQUIRED)
    set(KAMBARA_QCUSTOMPLOT QCustomPlotQt6::QCustomPlotQt6)
else()
    find_package(QCustomPlot REQUIRED)
    set(KAMBARA_QCUSTOMPLOT QCustomPlot::QCustomPlot)
endif()

# kambara_ui_library(ui_video SOURCES a.cpp ... PUBLIC core_vsystem ... PRIVATE ...)
function(kambara_ui_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    kambara_library(${name} SOURCES ${ARG_SOURCES}
        PUBLIC ${KAMBARA_QT_TARGET}Widgets ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
endfunction()
