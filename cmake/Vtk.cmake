# vs_use_vtk(TARGET COMPONENT ...): compiles TARGET with these parts of VTK.
function(vs_use_vtk TARGET)
  find_package(VTK 9.1 QUIET REQUIRED COMPONENTS ${ARGN})
  list(TRANSFORM ARGN PREPEND VTK::)
  target_link_libraries(${TARGET} PRIVATE ${ARGN})
endfunction()
