# Writes FILE from TEMPLATE with the commit of the sources in SOURCE, where it is another than before. Run at each build:
# cmake -D SOURCE=… -D TEMPLATE=… -D FILE=… -P commit.cmake
execute_process(
  COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude *
  OUTPUT_VARIABLE COMMIT
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(COMMIT "unknown")
endif()
configure_file(${TEMPLATE} ${FILE} @ONLY)
