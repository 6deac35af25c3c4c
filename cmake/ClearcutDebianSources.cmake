# Libraries of a build for another system: compiled from Debian's sources, and headers of Debian's packages for this one.

# clearcut_debian_source(OUT FOLDER PATTERN): the file of that pattern among the sources that `make` fetches into FOLDER.
function(clearcut_debian_source out folder pattern)
  file(GLOB found ${folder}/${pattern})
  if(NOT found)
    message(FATAL_ERROR "${folder}/${pattern} is missing; run make web or make windows, which fetch it by scripts/sources.sh")
  endif()
  list(GET found 0 found)
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# clearcut_debian_headers(FOLDER NAME...): links into /usr/include, whose other headers are this machine's.
function(clearcut_debian_headers folder)
  file(MAKE_DIRECTORY ${folder})
  foreach(name IN LISTS ARGN)
    if(NOT EXISTS /usr/include/${name})
      message(FATAL_ERROR "/usr/include/${name} is missing; run make web or make windows, which install it by scripts/setup.sh")
    endif()
    file(CREATE_LINK /usr/include/${name} ${folder}/${name} SYMBOLIC)
  endforeach()
endfunction()
