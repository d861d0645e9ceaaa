# Writes the man page: the template with the subcommands of the program's --help, and the same compressed (OUTPUT.gz).
# Input: PROGRAM TEMPLATE OUTPUT
execute_process(COMMAND "${PROGRAM}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${help}" "\nSubcommands:" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${PROGRAM} --help lists no subcommands")
endif()
string(SUBSTRING "${help}" ${at} -1 help)
string(ASCII 1 semicolon)  # a list would end there
string(REPLACE ";" "${semicolon}" help "${help}")
string(REPLACE "\\" "\\\\" help "${help}")  # a letter of roff
string(REPLACE "-" "\\-" help "${help}")
string(REGEX MATCHALL "\n  [a-z\\-]+  +[^\n]+" lines "${help}")
set(SUBCOMMANDS "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^\n  ([a-z\\-]+) +(.*)$" ".TP\n.B \\1\n\\2" entry "${line}")
  string(APPEND SUBCOMMANDS "${entry}\n")
endforeach()
string(REPLACE "${semicolon}" ";" SUBCOMMANDS "${SUBCOMMANDS}")
string(STRIP "${SUBCOMMANDS}" SUBCOMMANDS)
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
execute_process(COMMAND gzip -9 --no-name --keep --force "${OUTPUT}" COMMAND_ERROR_IS_FATAL ANY)
