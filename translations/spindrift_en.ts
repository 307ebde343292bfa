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
</TS>
