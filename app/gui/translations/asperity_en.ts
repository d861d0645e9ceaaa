<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>asperity::AnalysisPage</name>
    <message numerus="yes">
        <source>%n participants</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n responses</source>
        <translation>
            <numerusform>%n response</numerusform>
            <numerusform>%n responses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>README.txt contains %n further warning(s).</source>
        <translation>
            <numerusform>README.txt states %n further warning.</numerusform>
            <numerusform>README.txt states %n further warnings.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files are in %1; codebook.tsv describes every column.</source>
        <translation>
            <numerusform>%n file is in %1; codebook.tsv describes every column.</numerusform>
            <numerusform>%n files are in %1; codebook.tsv describes every column.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::AttemptPage</name>
    <message numerus="yes">
        <source>%n tick(s) are in %1; docs/formats/recording.md describes the columns.</source>
        <translation>
            <numerusform>%n tick is in %1; docs/formats/recording.md describes the columns.</numerusform>
            <numerusform>%n ticks are in %1; docs/formats/recording.md describes the columns.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::BatchSimulation</name>
    <message numerus="yes">
        <source>Simulating %n virtual participants …</source>
        <translation>
            <numerusform>Simulating %n virtual participant …</numerusform>
            <numerusform>Simulating %n virtual participants …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sessions were simulated.</source>
        <translation>
            <numerusform>%n session was simulated.</numerusform>
            <numerusform>%n sessions were simulated.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::CheckList</name>
    <message numerus="yes">
        <source>%n items must be resolved before the session can start.</source>
        <translation>
            <numerusform>%n item must be resolved before the session can start.</numerusform>
            <numerusform>%n items must be resolved before the session can start.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ready (%n warning(s)).</source>
        <translation>
            <numerusform>Ready (%n warning).</numerusform>
            <numerusform>Ready (%n warnings).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::EntryList</name>
    <message numerus="yes">
        <source>Remove “%1”, and with it %n entry(ies) of lists</source>
        <translation>
            <numerusform>Remove “%1”, and with it %n entry of a list</numerusform>
            <numerusform>Remove “%1”, and with it %n entries of lists</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::PrecisionView</name>
    <message numerus="yes">
        <source>%1; and %n other(s)</source>
        <translation>
            <numerusform>%1; and %n other</numerusform>
            <numerusform>%1; and %n others</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolFileActions</name>
    <message numerus="yes">
        <source>%1 has been run (%n sessions). Sessions refer to its name and its text: it can be neither renamed nor deleted. Duplicate it to create a further protocol from it.</source>
        <translation>
            <numerusform>%1 has been run (%n session). Sessions refer to its name and its text: it can be neither renamed nor deleted. Duplicate it to create a further protocol from it.</numerusform>
            <numerusform>%1 has been run (%n sessions). Sessions refer to its name and its text: it can be neither renamed nor deleted. Duplicate it to create a further protocol from it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolsPage</name>
    <message numerus="yes">
        <source>Simulate %n participants</source>
        <translation>
            <numerusform>Simulate %n participant</numerusform>
            <numerusform>Simulate %n participants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::SessionRunner</name>
    <message numerus="yes">
        <source>The force is zero and the session has stopped. Every completed trial is stored (%n attempt(s) since the session was started or resumed). Fix the cause, then resume this session on the Sessions page.</source>
        <translation>
            <numerusform>The force is zero and the session has stopped. Every completed trial is stored (%n attempt since the session was started or resumed). Fix the cause, then resume this session on the Sessions page.</numerusform>
            <numerusform>The force is zero and the session has stopped. Every completed trial is stored (%n attempts since the session was started or resumed). Fix the cause, then resume this session on the Sessions page.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::StartPage</name>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>And %n more.</numerusform>
            <numerusform>And %n more.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trials</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The program assigns the labels of virtual participants; the first of the next %n is %1.</source>
        <translation>
            <numerusform>The program assigns the labels of virtual participants; the next one is %1.</numerusform>
            <numerusform>The program assigns the labels of virtual participants; the first of the next %n is %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Simulate %n participants</source>
        <translation>
            <numerusform>Simulate %n participant</numerusform>
            <numerusform>Simulate %n participants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::StimuliPage</name>
    <message numerus="yes">
        <source>%n stimuli were copied.</source>
        <translation>
            <numerusform>%n stimulus was copied.</numerusform>
            <numerusform>%n stimuli were copied.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::TemplateDialog</name>
    <message numerus="yes">
        <source>This template compares %n texture(s).</source>
        <translation>
            <numerusform>This template compares %n texture.</numerusform>
            <numerusform>This template compares %n textures.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), about %1</source>
        <translation>
            <numerusform>%n trial, about %1</numerusform>
            <numerusform>%n trials, about %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::WithdrawDialog</name>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s)</source>
        <translation>
            <numerusform>%n recording</numerusform>
            <numerusform>%n recordings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n response(s)</source>
        <translation>
            <numerusform>%n response</numerusform>
            <numerusform>%n responses</numerusform>
        </translation>
    </message>
</context>
</TS>
