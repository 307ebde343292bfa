<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>spin::ExportDialog</name>
    <message numerus="yes">
        <source>%n frame(s), about %1 on disk</source>
        <translation>
            <numerusform>%n frame, about %1 on disk</numerusform>
            <numerusform>%n frames, about %1 on disk</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spin::FlakePanel</name>
    <message numerus="yes">
        <source>%n cell(s) of ice</source>
        <translation>
            <numerusform>%n cell of ice</numerusform>
            <numerusform>%n cells of ice</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n particle(s)</source>
        <translation>
            <numerusform>%n particle</numerusform>
            <numerusform>%n particles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spin::ImportFlow</name>
    <message numerus="yes">
        <source>%n file(s) copied to &quot;%1&quot;. Save the scene to use them from there.</source>
        <translation>
            <numerusform>%n file copied to &quot;%1&quot;. Save the scene to use it from there.</numerusform>
            <numerusform>%n files copied to &quot;%1&quot;. Save the scene to use them from there.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spin::MainWindow</name>
    <message numerus="yes">
        <source>The recovered scene is open; %n file(s) of the command line were not opened.</source>
        <translation>
            <numerusform>The recovered scene is open; %n file of the command line was not opened.</numerusform>
            <numerusform>The recovered scene is open; %n files of the command line were not opened.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spin::StatusPanel</name>
    <message numerus="yes">
        <source>%n frame(s): %1</source>
        <translation>
            <numerusform>%n frame: %1</numerusform>
            <numerusform>%n frames: %1</numerusform>
        </translation>
    </message>
</context>
</TS>
