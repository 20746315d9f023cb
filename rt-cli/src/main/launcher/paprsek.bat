@echo off
rem Starts Paprsek's command line with an archive of loaded classes, which saves time until the first pixel. Java 19 or newer makes it by itself;
rem 17 starts without. PAPRSEK_JAVA_OPTIONS is passed on to Java, as in set PAPRSEK_JAVA_OPTIONS=-Xmx8g.
setlocal
set "java=java"
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java"
set "cache=%LOCALAPPDATA%\paprsek"
if not exist "%cache%" mkdir "%cache%" 2> nul
rem One archive for each place of the jar, or two installations would make it anew at every start in turn.
set "place=%~dp0"
set "place=%place:\=-%"
set "archive=%cache%\rt-cli-%place::=%.jsa"
rem Vectors of eight floats pay for large files; Java says a line of that.
set "vectors="
if "%~1"=="bench" set "vectors=--add-modules jdk.incubator.vector"
for %%f in (%*) do if exist "%%~f" if %%~zf gtr 1000000 set "vectors=--add-modules jdk.incubator.vector"
if not defined vectors goto start
"%java%" --list-modules 2> nul | findstr /b "jdk.incubator.vector" > nul || set "vectors="
:start
"%java%" -XX:+IgnoreUnrecognizedVMOptions -XX:MaxGCPauseMillis=50 -Xshare:auto -XX:+AutoCreateSharedArchive "-XX:SharedArchiveFile=%archive%" -Xlog:disable -Xlog:all=error:stderr %vectors% %PAPRSEK_JAVA_OPTIONS% -jar "%~dp0rt-cli.jar" %*
