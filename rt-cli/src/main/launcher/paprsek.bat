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
set "compiler="
set "vectors="
set "command=%~1"
rem "call" and "set" would answer a question for help with their own, so these words go to the program as they are.
:asked
rem Quotes may stand within a word, so the word is not put into others; an empty one is two quotes.
if [%1]==[/?] goto start
if [%1]==["/?"] goto start
shift /1
if not [%1]==[] goto asked
if not "%command%"=="render" goto long
call :short %*
if not errorlevel 1 set "compiler=-XX:TieredStopAtLevel=1"
if defined compiler goto start
:long
rem Vectors of eight floats pay for large files; Java says a line of that.
if "%command%"=="bench" set "vectors=--add-modules jdk.incubator.vector"
rem A bracket in a name would end the list of names; "?" stands for it there.
set words=%*
if not defined words goto start
set words=%words:(=?%
set words=%words:)=?%
for %%f in (%words%) do if exist "%%~f" if %%~zf gtr 1000000 set "vectors=--add-modules jdk.incubator.vector"
if not defined vectors goto start
"%java%" --list-modules 2> nul | findstr /b "jdk.incubator.vector" > nul || set "vectors="
:start
"%java%" -XX:+IgnoreUnrecognizedVMOptions %compiler% -XX:MaxGCPauseMillis=50 -Xshare:auto -XX:+AutoCreateSharedArchive "-XX:SharedArchiveFile=%archive%" -Xlog:disable -Xlog:all=error:stderr %vectors% %PAPRSEK_JAVA_OPTIONS% -jar "%~dp0rt-cli.jar" %*
exit /b %errorlevel%

rem Whether the call is to render one picture so soon done that the compiler that makes the fastest code would take longer than it saves: up to a million
rem pixels with one ray each, of a file in which nothing stands for much more work than it is long. What is not known here is taken for long. The other
rem script says the same, and a little more of pictures that are higher than wide.
:short
set "scene="
set "size="
:word
shift
if "%~1"=="" goto words
if "%~1"=="-q" goto word
if "%~1"=="--quiet" goto word
if "%~1"=="-o" shift & goto word
if "%~1"=="--output" shift & goto word
if "%~1"=="--threads" shift & goto word
if "%~1"=="--size" set "size=%~2" & shift & goto word
set "word=%~1"
if "%word:~0,1%"=="-" exit /b 1
if defined scene exit /b 1
if not exist "%~1" exit /b 1
set "scene=%~1"
goto word
:words
if not defined scene exit /b 1
rem A pattern may be many files.
for %%f in ("%scene%") do if not "%%~f"=="%scene%" exit /b 1
for %%f in ("%scene%") do if %%~zf gtr 200000000 exit /b 1
findstr /r /c:"<scene[ >]" "%scene%" > nul 2> nul || exit /b 1
findstr /r /c:"<database" /c:"<include" /c:"<instance" /c:"<repeat" /c:"<mesh" /c:"<text" /c:"<isosurface" /c:"<height-field" /c:"<area-light" /c:"<sphere-light" /c:"<sky" /c:"<roughness" /c:"samples=.[^1]" /c:"samples=.1[0-9.]" /c:"width=.[^0-9]" /c:"height=.[^0-9]" /c:"integrator=.p" /c:"integrator= " /c:"aperture=" /c:"angle=" /c:"shutter=" /c:"error=" /c:" =" "%scene%" > nul && exit /b 1
if defined size goto sized
findstr /r /c:"height=.[0-9][0-9][0-9][0-9]" /c:"width=.[0-9][0-9][0-9][0-9][0-9]" /c:"width=.[2-9][0-9][0-9][0-9]" /c:"width=.1[3-9][0-9][0-9]" "%scene%" > nul && exit /b 1
rem 1299 by 769 are a million, and so are 999 by 999.
findstr /r /c:"width=.1[0-2][0-9][0-9]" "%scene%" > nul || exit /b 0
findstr /r /c:"height=.[89][0-9][0-9]" /c:"height=.7[7-9][0-9]" "%scene%" > nul && exit /b 1
exit /b 0
:sized
for /f "delims=0123456789xX" %%a in ("%size%") do exit /b 1
set "width="
set "height="
for /f "tokens=1 delims=xX" %%a in ("%size%") do set "width=%%a"
for /f "tokens=2 delims=xX" %%a in ("%size%") do set "height=%%a"
for /f "tokens=3 delims=xX" %%a in ("%size%") do exit /b 1
if not defined width exit /b 1
if not defined height exit /b 1
if %width% gtr 9999 exit /b 1
if %height% gtr 9999 exit /b 1
if "%width:~0,1%"=="0" exit /b 1
if "%height:~0,1%"=="0" exit /b 1
set /a "pixels=%width% * %height%"
if %pixels% leq 1000000 exit /b 0
exit /b 1
