# Most files are small. Compiled with others of their folder they read the headers, and instantiate the templates, that they
# share once: half of the build's time. What a file keeps to itself must then have a name of its own within its folder.

set(LUMI_FILES_AT_ONCE 8)

# Every target of TYPE in FOLDER compiles the files of one folder together.
function(lumi_compile_by_folder folder type)
  lumi_targets_in(targets ${folder} ${type})
  foreach(target IN LISTS targets)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    get_target_property(directory ${target} SOURCE_DIR)
    set(counted_folders)
    foreach(source IN LISTS sources)
      get_filename_component(its_folder ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "folder_${its_folder}" group)
      if(NOT group IN_LIST counted_folders)
        list(APPEND counted_folders ${group})
        set(${group} 0)
      endif()
      math(EXPR part "${${group}} / ${LUMI_FILES_AT_ONCE}")
      math(EXPR ${group} "${${group}} + 1")
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${directory})
      set_source_files_properties(${source} DIRECTORY ${directory} PROPERTIES UNITY_GROUP ${group}_${part})
    endforeach()
  endforeach()
endfunction()
