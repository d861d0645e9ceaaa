<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>Analysis</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Only %1 were presented: one was confused with the other (responses: %2 of %3).</source>
        <translation>Nur %1 wurden dargeboten: Die eine Textur wurde mit der anderen verwechselt (Antworten: %2 von %3).</translation>
    </message>
    <message>
        <source>%1 interrupted</source>
        <translation>%1 unterbrochen</translation>
    </message>
    <message>
        <source>%1 answered but invalid</source>
        <translation>%1 beantwortet, aber ungültig</translation>
    </message>
    <message>
        <source>%1 excluded</source>
        <translation>%1 ausgeschlossen</translation>
    </message>
    <message>
        <source>%1 skipped</source>
        <translation>%1 übersprungen</translation>
    </message>
    <message>
        <source>These sessions are pilots: they are analysed separately from sessions of mode &quot;run&quot;.</source>
        <translation>Diese Sitzungen sind Pilotsitzungen: Sie werden getrennt von den Sitzungen im Modus „Erhebung“ ausgewertet.</translation>
    </message>
    <message>
        <source>%1 different files have this protocol name and version; their responses are pooled. Give a changed protocol a new version.</source>
        <translation>%1 verschiedene Dateien haben diesen Protokollnamen und diese Version; ihre Antworten werden zusammengefasst. Einem geänderten Protokoll eine neue Version geben.</translation>
    </message>
    <message>
        <source>Recordings that cannot be read, so that the properties of the stimuli lack their forces: %1. &quot;asperity verify&quot; names the files; restore them from a copy of the study.</source>
        <translation>Nicht lesbare Aufzeichnungen, deren Kräfte den Eigenschaften der Reize fehlen: %1. „asperity verify“ nennt die Dateien; sie sind aus einer Kopie der Studie wiederherzustellen.</translation>
    </message>
    <message>
        <source>Sessions that were not completed: %1 of %2.</source>
        <translation>Nicht abgeschlossene Sitzungen: %1 von %2.</translation>
    </message>
    <message>
        <source>Sessions that began on a device on which no participant can feel the surfaces (without motors, or moved by the program): %1 of %2.</source>
        <translation>Sitzungen, die an einem Gerät begannen, an dem keine Versuchsperson die Oberflächen fühlen kann (ohne Motoren oder vom Programm bewegt): %1 von %2.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Attempts that do not count: %1.</source>
        <translation>Versuche, die nicht zählen: %1.</translation>
    </message>
    <message>
        <source>This program has no analysis for protocols of the kind &quot;%1&quot;; export the tables and analyse them with another program.</source>
        <translation>Dieses Programm hat keine Auswertung für Protokolle der Art „%1“; die Tabellen exportieren und mit einem anderen Programm auswerten.</translation>
    </message>
    <message>
        <source>Responses left out because they do not assign each picture to exactly one surface, so that the chance level of a permutation does not apply: %1.</source>
        <translation>Antworten, die weggelassen wurden, weil sie nicht jedes Bild genau einer Oberfläche zuordnen und das Zufallsniveau einer Permutation daher nicht gilt: %1.</translation>
    </message>
    <message>
        <source>Trials with all items correct (counts)</source>
        <translation>Durchgänge, in denen alle Zuordnungen richtig sind (Anzahlen)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Chance level: all items correct in 1/%1 of the trials.</source>
        <translation>Zufallsniveau: alle Zuordnungen richtig in 1/%1 der Durchgänge.</translation>
    </message>
    <message>
        <source>Chance level: 1/%1 of the items correct.</source>
        <translation>Zufallsniveau: 1/%1 der Zuordnungen richtig.</translation>
    </message>
    <message>
        <source>Proportion of trials with all items correct</source>
        <translation>Anteil der Durchgänge, in denen alle Zuordnungen richtig sind</translation>
    </message>
    <message>
        <source>The chance level is 1/m! for m items. p: exact binomial test, two-sided, uncorrected for the number of rows.</source>
        <translation>Das Zufallsniveau ist 1/m! bei m Zuordnungen. p: exakter Binomialtest, zweiseitig, nicht für die Anzahl der Zeilen korrigiert.</translation>
    </message>
    <message>
        <source>Proportion of correctly matched items</source>
        <translation>Anteil richtiger Zuordnungen</translation>
    </message>
    <message>
        <source>Proportion of correctly matched items, by texture</source>
        <translation>Anteil richtiger Zuordnungen nach Textur</translation>
    </message>
    <message>
        <source>The chance level of each texture is 1/m. The rows are not independent of each other.</source>
        <translation>Das Zufallsniveau jeder Textur ist 1/m. Die Zeilen hängen voneinander ab.</translation>
    </message>
    <message>
        <source>Responses in trials without a declared correct response, left out: %1.</source>
        <translation>Weggelassene Antworten in Durchgängen ohne festgelegte richtige Antwort: %1.</translation>
    </message>
    <message>
        <source>Correct responses (counts)</source>
        <translation>Richtige Antworten (Anzahlen)</translation>
    </message>
    <message>
        <source>Chance level: 1/%1 of the responses correct.</source>
        <translation>Zufallsniveau: 1/%1 der Antworten richtig.</translation>
    </message>
    <message>
        <source>Proportion correct</source>
        <translation>Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>Proportion correct, by texture</source>
        <translation>Anteil richtiger Antworten nach Textur</translation>
    </message>
    <message>
        <source>Proportion of choices of each model, by texture</source>
        <translation>Anteil jedes Modells an den Wahlen, nach Textur</translation>
    </message>
    <message>
        <source>Chance level: 1/%1 of the choices for each model.</source>
        <translation>Zufallsniveau: 1/%1 der Wahlen für jedes Modell.</translation>
    </message>
    <message>
        <source>Proportion of choices of each model</source>
        <translation>Anteil jedes Modells an den Wahlen</translation>
    </message>
    <message>
        <source>The chance level is 1 divided by the number of surfaces presented. p: exact binomial test, two-sided, uncorrected for the number of rows; the proportions of one column are not independent of each other.</source>
        <translation>Das Zufallsniveau ist 1 geteilt durch die Anzahl der dargebotenen Oberflächen. p: exakter Binomialtest, zweiseitig, nicht für die Anzahl der Zeilen korrigiert; die Anteile einer Spalte hängen voneinander ab.</translation>
    </message>
    <message>
        <source>Pairwise comparisons of the models, among the choices of either model</source>
        <translation>Paarvergleiche der Modelle, unter den Wahlen eines der beiden Modelle</translation>
    </message>
    <message>
        <source>The chance level is 1/2: choices of a third model are not counted.</source>
        <translation>Das Zufallsniveau ist 1/2: Wahlen eines dritten Modells werden nicht gezählt.</translation>
    </message>
    <message>
        <source>The chance level differs between trials.</source>
        <translation>Das Zufallsniveau unterscheidet sich zwischen den Durchgängen.</translation>
    </message>
    <message>
        <source>Texture force (RMS) per model, as computed in the attempts</source>
        <translation>Effektivwert der Texturkraft je Modell, wie in den Versuchen berechnet</translation>
    </message>
    <message>
        <source>Texture force (RMS) per model, as computed: intended on the prescribed path, and achieved in the attempts</source>
        <translation>Effektivwert der Texturkraft je Modell, wie berechnet: angestrebt auf dem vorgegebenen Weg und erreicht in den Versuchen</translation>
    </message>
    <message>
        <source>This cannot be tested: no participant ever chose %1.</source>
        <translation>Das lässt sich nicht prüfen: Keine Versuchsperson hat je %1 gewählt.</translation>
    </message>
    <message>
        <source>%1 Participants who never chose %2 do not contribute: %3 of %4.</source>
        <translation>%1 Versuchspersonen, die nie %2 gewählt haben, tragen nichts bei: %3 von %4.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Equal RMS does not mean equal perceived intensity, which also depends on frequency. The force achieved depends on how the participant pressed and moved the handle.</source>
        <translation>Gleiche Effektivwerte bedeuten nicht gleiche wahrgenommene Stärke; diese hängt auch von der Frequenz ab. Die erreichte Kraft hängt davon ab, wie die Versuchsperson den Griff gedrückt und bewegt hat.</translation>
    </message>
    <message>
        <source>These files declare different tests, so that no test counts as declared before data collection; give a protocol with changed tests a new version.</source>
        <translation>Diese Dateien legen verschiedene Tests fest, daher gilt kein Test als vor der Datenerhebung festgelegt; einem Protokoll mit geänderten Tests eine neue Version geben.</translation>
    </message>
    <message>
        <source>Confused pairs of textures, the most frequent first</source>
        <translation>Verwechselte Paare von Texturen, das häufigste zuerst</translation>
    </message>
    <message>
        <source>Number of times that one texture was assigned the picture of the other, in each direction.</source>
        <translation>Anzahl der Fälle, in denen einer Textur das Bild der anderen zugeordnet wurde, für jede Richtung.</translation>
    </message>
    <message>
        <source>Trials by their number of correctly matched items</source>
        <translation>Durchgänge nach der Anzahl ihrer richtigen Zuordnungen</translation>
    </message>
    <message>
        <source>Are textures matched to their pictures above chance?</source>
        <translation>Werden Texturen ihren Bildern überzufällig häufig zugeordnet?</translation>
    </message>
    <message>
        <source>How often are all items of a trial correct?</source>
        <translation>Wie häufig sind in einem Durchgang alle Zuordnungen richtig?</translation>
    </message>
    <message>
        <source>No texture was confused with another.</source>
        <translation>Keine Textur wurde mit einer anderen verwechselt.</translation>
    </message>
    <message>
        <source>Counts of all responses; a CI would require a model of the confusions.</source>
        <translation>Anzahlen aus allen Antworten; für ein Konfidenzintervall wäre ein Modell der Verwechslungen nötig.</translation>
    </message>
    <message>
        <source>No response assigns each picture to exactly one surface, so that the matchings are not analysed; ask participants to assign every picture.</source>
        <translation>Keine Antwort ordnet jedes Bild genau einer Oberfläche zu, daher werden die Zuordnungen nicht ausgewertet; Versuchspersonen bitten, jedes Bild zuzuordnen.</translation>
    </message>
    <message>
        <source>Similarity of the textures</source>
        <translation>Ähnlichkeit der Texturen</translation>
    </message>
    <message>
        <source>MDS configuration of the textures</source>
        <translation>MDS-Konfiguration der Texturen</translation>
    </message>
    <message>
        <source>Classical scaling of the dissimilarities. Only distances can be interpreted: the configuration may be rotated and mirrored.</source>
        <translation>Klassische Skalierung der Unähnlichkeiten. Nur Abstände sind interpretierbar: Die Konfiguration darf gedreht und gespiegelt werden.</translation>
    </message>
    <message>
        <source>Dendrogram of the textures</source>
        <translation>Dendrogramm der Texturen</translation>
    </message>
    <message>
        <source>Average linkage of the dissimilarities. Each row joins the cluster of the first texture with that of the second.</source>
        <translation>Average Linkage der Unähnlichkeiten. In jeder Zeile wird der Cluster der ersten Textur mit dem der zweiten zusammengeführt.</translation>
    </message>
    <message>
        <source>Are textures recognised above chance?</source>
        <translation>Werden Texturen überzufällig häufig erkannt?</translation>
    </message>
    <message>
        <source>On average %1 of a participant&apos;s responses were correct (%2), compared with a chance level of %3; all participants have the same proportion correct, so there is no test.</source>
        <translation>Im Mittel waren %1 der Antworten einer Versuchsperson richtig (%2), bei einem Zufallsniveau von %3; alle Versuchspersonen haben denselben Anteil richtiger Antworten, also gibt es keinen Test.</translation>
    </message>
    <message>
        <source>d′ has no finite value</source>
        <translation>d′ hat keinen endlichen Wert</translation>
    </message>
    <message>
        <source>Transmitted information about the texture presented, bias-corrected: %1 of %2 bits; %3.</source>
        <translation>Übertragene Information über die dargebotene Textur, bias-korrigiert: %1 von %2 Bit; %3.</translation>
    </message>
    <message>
        <source>Transmitted information about the texture presented: about %1 of %2 bits; with so few responses the bias correction is not reliable; %3.</source>
        <translation>Übertragene Information über die dargebotene Textur: etwa %1 von %2 Bit; bei so wenigen Antworten ist die Bias-Korrektur nicht verlässlich; %3.</translation>
    </message>
    <message>
        <source>How much information do the responses transmit?</source>
        <translation>Wie viel Information übertragen die Antworten?</translation>
    </message>
    <message>
        <source>Transmitted information, bias-corrected (Miller 1955); at least 5·m² responses are needed for m pictures. d′ for m alternatives, assuming no response bias, all responses pooled; its CI is derived from the Wilson limits of the proportion correct.</source>
        <translation>Übertragene Information, bias-korrigiert (Miller 1955); für m Bilder sind mindestens 5·m² Antworten nötig. d′ für m Alternativen, aus allen Antworten zusammen, unter der Annahme, dass es keine Antworttendenz gibt; sein Konfidenzintervall ist aus den Wilson-Grenzen des Anteils richtiger Antworten abgeleitet.</translation>
    </message>
    <message>
        <source>Which textures are confused with each other?</source>
        <translation>Welche Texturen werden miteinander verwechselt?</translation>
    </message>
    <message>
        <source>The pictures, and therefore the chance level, differ between trials: sensitivity, information and similarities over all responses are not meaningful and are left out.</source>
        <translation>Die Bilder und mit ihnen das Zufallsniveau unterscheiden sich zwischen den Durchgängen: Sensitivität, Information und Ähnlichkeiten aller Antworten zusammen haben keine Bedeutung und entfallen.</translation>
    </message>
    <message>
        <source>Proportion of choices of each position</source>
        <translation>Anteil jeder Position an den Wahlen</translation>
    </message>
    <message>
        <source>The position is the place of a surface in the order of presentation, regardless of its model. Where the order of surfaces is random, a proportion above the chance level is a position bias, not a preference.</source>
        <translation>Die Position ist der Platz einer Oberfläche in der Reihenfolge der Darbietung, unabhängig von ihrem Modell. Wenn die Reihenfolge der Oberflächen zufällig ist, ist ein Anteil über dem Zufallsniveau ein Positionseffekt, keine Präferenz.</translation>
    </message>
    <message>
        <source>The models cannot be placed on a scale: one of them was always or never chosen when it was presented, or was never presented with the others, so that its distance has no finite estimate. Collect more choices with this model.</source>
        <translation>Die Modelle lassen sich nicht auf einer Skala anordnen: Eines wurde immer oder nie gewählt, wenn es dargeboten wurde, oder nie zusammen mit den anderen dargeboten, sodass es für seinen Abstand keine endliche Schätzung gibt. Mehr Wahlen mit diesem Modell erheben.</translation>
    </message>
    <message>
        <source>The models on one scale</source>
        <translation>Die Modelle auf einer Skala</translation>
    </message>
    <message>
        <source>There are no choices yet; run a session first.</source>
        <translation>Es gibt noch keine Wahlen; erst eine Sitzung durchführen.</translation>
    </message>
    <message>
        <source>%1 over %2 (%3)</source>
        <translation>%1 vor %2 (%3)</translation>
    </message>
    <message>
        <source>For each pair, exact sign-flip (randomisation) test of each participant&apos;s difference between the two counts (both labels exchanged within a participant). Choices of a third model are not counted.</source>
        <translation>Für jedes Paar ein exakter Vorzeichen-Permutationstest der Differenz der beiden Wahlhäufigkeiten jeder Versuchsperson (beide Namen innerhalb einer Versuchsperson vertauscht). Wahlen eines dritten Modells werden nicht gezählt.</translation>
    </message>
    <message>
        <source>Chosen more often: %1.</source>
        <translation>Häufiger gewählt: %1.</translation>
    </message>
    <message>
        <source>Does the position in the trial matter?</source>
        <translation>Spielt die Position im Durchgang eine Rolle?</translation>
    </message>
    <message>
        <source>Permutation test of each participant&apos;s number of choices of the target with each texture: the textures are exchanged at random within each participant. Where each texture was judged once, this is the exact form of Cochran&apos;s Q test.</source>
        <translation>Permutationstest der Häufigkeit, mit der jede Versuchsperson das Ziel bei jeder Textur wählte: Die Texturen werden innerhalb jeder Versuchsperson zufällig vertauscht. Wenn jede Textur einmal beurteilt wurde, ist das die exakte Form von Cochrans Q-Test.</translation>
    </message>
    <message>
        <source>This cannot be tested: the participants have not judged every texture equally often.</source>
        <translation>Das lässt sich nicht prüfen: Die Versuchspersonen haben nicht jede Textur gleich häufig beurteilt.</translation>
    </message>
    <message>
        <source>No surface was presented before these responses, so that no comparison is possible; collect further responses.</source>
        <translation>Vor diesen Antworten wurde keine Oberfläche dargeboten, sodass kein Vergleich möglich ist; weitere Antworten erheben.</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Tests</translation>
    </message>
    <message>
        <source>no CI, because there is only one participant</source>
        <translation>kein Konfidenzintervall, weil es nur eine Versuchsperson gibt</translation>
    </message>
    <message>
        <source>Do women and men differ?</source>
        <translation>Unterscheiden sich Frauen und Männer?</translation>
    </message>
    <message>
        <source>Measures of all responses together</source>
        <translation>Kennwerte aus allen Antworten zusammen</translation>
    </message>
    <message>
        <source>No texture was ever confused with another one that was presented.</source>
        <translation>Keine Textur wurde je mit einer anderen dargebotenen verwechselt.</translation>
    </message>
    <message>
        <source>The following pairs are confused equally often: %1; one texture with the other in %2 of the responses to the two textures of each pair.</source>
        <translation>Die folgenden Paare wurden gleich häufig verwechselt: %1; die eine Textur mit der anderen in %2 der Antworten auf die beiden Texturen jedes Paars.</translation>
    </message>
    <message>
        <source>%1 pairs of textures are confused equally often, and none more often: one texture with the other in %2 of the responses to the two textures of each pair.</source>
        <translation>%1 Paare von Texturen wurden gleich häufig verwechselt, keines häufiger: die eine Textur mit der anderen in %2 der Antworten auf die beiden Texturen jedes Paars.</translation>
    </message>
    <message>
        <source>The file study.sqlite is larger than 1 GiB, so its checksum was not compared. Run &quot;asperity verify&quot; to check the study.</source>
        <translation>Die Datei study.sqlite ist größer als 1 GiB, deshalb wurde ihre Prüfsumme nicht verglichen. Die Studie mit „asperity verify“ prüfen.</translation>
    </message>
    <message>
        <source>The file study.sqlite has changed since Asperity last closed it: data read from it may be incorrect. Run &quot;asperity verify&quot; to list the errors and their possible causes.</source>
        <translation>Die Datei study.sqlite hat sich geändert, seit Asperity sie zuletzt geschlossen hat: Daten daraus können falsch sein. „asperity verify“ listet die Fehler und ihre möglichen Ursachen auf.</translation>
    </message>
    <message>
        <source>%1 stopped by a fault</source>
        <translation>%1 durch eine Störung gestoppt</translation>
    </message>
    <message>
        <source>%1 not explored as instructed</source>
        <translation>%1 nicht wie angewiesen exploriert</translation>
    </message>
    <message>
        <source>%1 not answered in time</source>
        <translation>%1 nicht rechtzeitig beantwortet</translation>
    </message>
    <message>
        <source>Sessions of virtual participants that ignore the surface or have no expectations, so that their responses are guesses: %1.</source>
        <translation>Sitzungen virtueller Versuchspersonen, die die Oberfläche nicht beachten oder keine Erwartung haben, sodass ihre Antworten geraten sind: %1.</translation>
    </message>
    <message>
        <source>Expected under guessing: number of trials if every assignment is equally likely.</source>
        <translation>Beim Raten erwartet: Anzahl der Durchgänge, wenn jede Zuordnung gleich wahrscheinlich ist.</translation>
    </message>
    <message>
        <source>The chance level is 1 divided by the number of pictures shown; “cannot tell” counts as incorrect. p: exact binomial test, two-sided, uncorrected for the number of rows.</source>
        <translation>Das Zufallsniveau ist 1 geteilt durch die Anzahl der gezeigten Bilder; „kann es nicht sagen“ zählt als falsch. p: exakter Binomialtest, zweiseitig, nicht für die Anzahl der Zeilen korrigiert.</translation>
    </message>
    <message>
        <source>%1 “Cannot tell” responses are counted in the table of counts and left out here.</source>
        <translation>%1 Antworten „kann es nicht sagen“ sind in der Tabelle der Anzahlen gezählt und hier weggelassen.</translation>
    </message>
    <message>
        <source>one participant</source>
        <translation>eine Versuchsperson</translation>
    </message>
    <message>
        <source>%1 participants</source>
        <translation>%1 Versuchspersonen</translation>
    </message>
    <message>
        <source>%1 (%2, n = %3)</source>
        <translation>%1 (%2, n = %3)</translation>
    </message>
    <message>
        <source>%1 percentage points (%2)</source>
        <translation>%1 Prozentpunkte (%2)</translation>
    </message>
    <message>
        <source>%1 items (%2)</source>
        <translation>%1 Zuordnungen (%2)</translation>
    </message>
    <message>
        <source>Responses left out because they are not numbers above 0, or because the protocol does not state their spacing: %1.</source>
        <translation>Weggelassene Antworten (keine Zahl über 0, oder im Protokoll ist kein Abstand angegeben): %1.</translation>
    </message>
    <message>
        <source>Estimates of anchors, which are not analysed: %1.</source>
        <translation>Schätzungen von Ankern, die nicht ausgewertet werden: %1.</translation>
    </message>
    <message>
        <source>Roughness by spacing and condition</source>
        <translation>Rauheit nach Abstand und Bedingung</translation>
    </message>
    <message>
        <source>Estimates of each participant</source>
        <translation>Schätzungen der einzelnen Versuchspersonen</translation>
    </message>
    <message>
        <source>Geometric means over repetitions. The estimates of participants with an empty cell are not normalised and are left out of curves and tests.</source>
        <translation>Geometrische Mittel über Wiederholungen. Schätzungen von Versuchspersonen mit einer leeren Zelle werden nicht normiert und bleiben in Kurven und Tests unberücksichtigt.</translation>
    </message>
    <message>
        <source>Spacing of maximum roughness: one parabola per condition</source>
        <translation>Abstand der größten Rauheit: eine Parabel je Bedingung</translation>
    </message>
    <message>
        <source>Ratios of the peaks</source>
        <translation>Verhältnisse der Maxima</translation>
    </message>
    <message>
        <source>Ratio of the spacing of the first peak to that of the second, with the same participants in both; delta method. p is uncorrected.</source>
        <translation>Verhältnis des Abstands beim ersten Maximum zu dem beim zweiten, mit denselben Versuchspersonen; Delta-Methode. p ist unkorrigiert.</translation>
    </message>
    <message>
        <source>Repeated-measures ANOVA of the log estimates</source>
        <translation>Varianzanalyse mit Messwiederholung der logarithmierten Schätzungen</translation>
    </message>
    <message>
        <source>Each participant has a value in every cell; repetitions are averaged. p: Greenhouse–Geisser-corrected where an effect has more than one degree of freedom.</source>
        <translation>Jede Versuchsperson hat einen Wert in jeder Zelle; Wiederholungen sind gemittelt. p: Greenhouse-Geisser-korrigiert, wenn ein Effekt mehr als einen Freiheitsgrad hat.</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Which spacing is judged roughest?</source>
        <translation>Welcher Abstand wird als der raueste beurteilt?</translation>
    </message>
    <message>
        <source>Which shapes do the participants&apos; own curves have?</source>
        <translation>Welche Formen haben die Kurven der einzelnen Versuchspersonen?</translation>
    </message>
    <message>
        <source>Shapes of the participants&apos; curves, all conditions together: descending %1, inverted U %2, other %3.</source>
        <translation>Formen der Kurven der Versuchspersonen, alle Bedingungen zusammen: fallend %1, umgekehrtes U %2, andere %3.</translation>
    </message>
    <message>
        <source>The shape is determined by the slopes of each participant&apos;s own parabola at the smallest and the largest spacing; there is no test.</source>
        <translation>Die Form wird nach den Steigungen der individuellen Parabel jeder Versuchsperson beim kleinsten und beim größten Abstand bestimmt; es gibt keinen Test.</translation>
    </message>
    <message>
        <source>Participants with an empty cell, who are left out of curves and tests: %1.</source>
        <translation>Versuchspersonen mit einer leeren Zelle, die in Kurven und Tests unberücksichtigt bleiben: %1.</translation>
    </message>
    <message>
        <source>Does roughness depend on the spacing?</source>
        <translation>Hängt die Rauheit vom Abstand ab?</translation>
    </message>
    <message>
        <source>Does roughness depend on the condition?</source>
        <translation>Hängt die Rauheit von der Bedingung ab?</translation>
    </message>
    <message>
        <source>Does the curve over spacings depend on the condition?</source>
        <translation>Hängt die Kurve über die Abstände von der Bedingung ab?</translation>
    </message>
    <message>
        <source>%1 outside the range of the tested spacings</source>
        <translation>%1 außerhalb des Bereichs der geprüften Abstände</translation>
    </message>
    <message>
        <source>%1 without a peak, because the parabola opens upwards</source>
        <translation>%1 ohne Maximum, weil die Parabel nach oben geöffnet ist</translation>
    </message>
    <message>
        <source>Peaks of the curves: %1.</source>
        <translation>Maxima der Kurven: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be determined, because with %2 participants its CI is wider than the range of the tested spacings</source>
        <translation>%1 lässt sich nicht bestimmen: Bei %2 Versuchspersonen ist das Konfidenzintervall breiter als der Bereich der geprüften Abstände</translation>
    </message>
    <message>
        <source>%1 was roughest and %2 least rough (ratio of geometric means: %3)</source>
        <translation>%1 war am rauesten und %2 am wenigsten rau (Verhältnis der geometrischen Mittel: %3)</translation>
    </message>
    <message>
        <source>%1 was rougher than %2 by a factor of %3</source>
        <translation>%1 war um den Faktor %3 rauer als %2</translation>
    </message>
    <message>
        <source>%1, partial η² = %2, %3</source>
        <translation>%1, partielles η² = %2, %3</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>The participants&apos; cells contain %1 to %2 estimates; each cell is averaged first, so that all cells have equal weight.</source>
        <translation>Die Zellen der Versuchspersonen enthalten %1 bis %2 Schätzungen; jede Zelle wird zuerst gemittelt, sodass alle Zellen gleiches Gewicht haben.</translation>
    </message>
    <message>
        <source>%1 ended by the emergency stop</source>
        <translation>%1 durch NOT-HALT beendet</translation>
    </message>
    <message>
        <source>%1 pairs are confused equally often, and none more often; number of confusions, counted in both directions: %2.</source>
        <translation>%1 Paare wurden gleich häufig verwechselt, keines häufiger; Anzahl der Verwechslungen, in beiden Richtungen gezählt: %2.</translation>
    </message>
    <message>
        <source>%1 and %2 are confused most often; number of confusions, counted in both directions: %3.</source>
        <translation>Am häufigsten wurden %1 und %2 verwechselt; Anzahl der Verwechslungen, in beiden Richtungen gezählt: %3.</translation>
    </message>
    <message>
        <source>%1 Counted in one direction only, the most frequent confusion is %2 (responses: %3 of %4).</source>
        <translation>%1 Wird nur eine Richtung gezählt, ist %2 die häufigste Verwechslung (Antworten: %3 von %4).</translation>
    </message>
    <message>
        <source>The textures confused most often are %1: one with the other (responses: %2 of %3).</source>
        <translation>Am häufigsten verwechselt wurden %1: die eine mit der anderen (Antworten: %2 von %3).</translation>
    </message>
    <message>
        <source>%1 Counted in one direction only, %2 confusions are the most frequent: each in %3 of the responses to the texture presented.</source>
        <translation>%1 Wird nur eine Richtung gezählt, sind %2 Verwechslungen die häufigsten: jede in %3 der Antworten auf die dargebotene Textur.</translation>
    </message>
    <message>
        <source>%1 Counted in one direction only, these confusions are the most frequent: %2, each in %3 of the responses to the texture presented.</source>
        <translation>%1 Wird nur eine Richtung gezählt, sind diese Verwechslungen die häufigsten: %2, jede in %3 der Antworten auf die dargebotene Textur.</translation>
    </message>
    <message>
        <source>%1 identified as %2</source>
        <translation>%1 als %2 erkannt</translation>
    </message>
    <message>
        <source>Chance level: each model in 1/%1 of the choices in the trials in which it was presented.</source>
        <translation>Zufallsniveau: jedes Modell in 1/%1 der Wahlen in den Durchgängen, in denen es dargeboten wurde.</translation>
    </message>
    <message>
        <source>Not every model is presented in every trial: each pair is tested on the trials in which both were presented, and the scale combines all trials.</source>
        <translation>Nicht jedes Modell wird in jedem Durchgang dargeboten: Jedes Paar wird in den Durchgängen geprüft, in denen beide dargeboten wurden, und die Skala fasst alle Durchgänge zusammen.</translation>
    </message>
    <message>
        <source>All were chosen equally often: each in %1 of a participant&apos;s choices on average, compared with a chance level of %2</source>
        <translation>Alle wurden gleich häufig gewählt: im Mittel jeweils in %1 der Wahlen einer Versuchsperson, bei einem Zufallsniveau von %2</translation>
    </message>
    <message>
        <source>Both were chosen equally often: each in %1 of a participant&apos;s choices on average, compared with a chance level of %2</source>
        <translation>Beide wurden gleich häufig gewählt: im Mittel jeweils in %1 der Wahlen einer Versuchsperson, bei einem Zufallsniveau von %2</translation>
    </message>
    <message>
        <source>%1 do not differ significantly (%2).</source>
        <translation>%1 unterscheiden sich nicht signifikant (%2).</translation>
    </message>
    <message>
        <source>%1 were chosen equally often, and most often: each in %2 of a participant&apos;s choices on average, compared with a chance level of %3</source>
        <translation>%1 wurden gleich häufig und am häufigsten gewählt: im Mittel jeweils in %2 der Wahlen einer Versuchsperson, bei einem Zufallsniveau von %3</translation>
    </message>
    <message>
        <source>%1 was chosen most often: in %2 of a participant&apos;s choices on average (%3), compared with a chance level of %4</source>
        <translation>%1 wurde am häufigsten gewählt: im Mittel in %2 der Wahlen einer Versuchsperson (%3), bei einem Zufallsniveau von %4</translation>
    </message>
    <message>
        <source>%1, 95 % CI [%2, %3]</source>
        <translation>%1, 95-%-KI [%2; %3]</translation>
    </message>
    <message>
        <source>The scale cannot be estimated: a model was always or never chosen, or the trials do not link all models. Collect more choices.</source>
        <translation>Die Skala lässt sich nicht schätzen: Ein Modell wurde immer oder nie gewählt, oder die Durchgänge verbinden nicht alle Modelle. Mehr Wahlen erheben.</translation>
    </message>
    <message>
        <source>the smallest p is shared by %1 pairs (each %2)</source>
        <translation>das kleinste p haben %1 Paare (jeweils %2)</translation>
    </message>
    <message>
        <source>the smallest p is that of %1 (%2)</source>
        <translation>das kleinste p hat %1 (%2)</translation>
    </message>
    <message>
        <source>the smallest p is shared by %1 (each %2)</source>
        <translation>das kleinste p haben %1 (jeweils %2)</translation>
    </message>
    <message>
        <source>%1 over %2 (in %3 of a participant&apos;s choices on average, %4; %5)</source>
        <translation>%1 vor %2 (im Mittel in %3 der Wahlen einer Versuchsperson, %4; %5)</translation>
    </message>
    <message>
        <source>all positions were chosen equally often, each in %1 of a participant&apos;s choices on average</source>
        <translation>alle Positionen wurden gleich häufig gewählt, im Mittel jeweils in %1 der Wahlen einer Versuchsperson</translation>
    </message>
    <message>
        <source>the positions %1 were chosen equally often, each in %2 of a participant&apos;s choices on average, compared with a chance level of %3</source>
        <translation>die Positionen %1 wurden gleich häufig gewählt, im Mittel jeweils in %2 der Wahlen einer Versuchsperson, bei einem Zufallsniveau von %3</translation>
    </message>
    <message>
        <source>the positions %1 were chosen equally often, each in %2 of a participant&apos;s choices on average, and the first position in %3 (%4), compared with a chance level of %5</source>
        <translation>die Positionen %1 wurden gleich häufig gewählt, im Mittel jeweils in %2 der Wahlen einer Versuchsperson, und die erste Position in %3 (%4), bei einem Zufallsniveau von %5</translation>
    </message>
    <message>
        <source>the first position was chosen in %1 of a participant&apos;s choices on average (%2), compared with a chance level of %3</source>
        <translation>die erste Position wurde im Mittel in %1 der Wahlen einer Versuchsperson gewählt (%2), bei einem Zufallsniveau von %3</translation>
    </message>
    <message>
        <source>position %1 was chosen in %2 of a participant&apos;s choices on average (%3), and the first position in %4 (%5), compared with a chance level of %6</source>
        <translation>Position %1 wurde im Mittel in %2 der Wahlen einer Versuchsperson gewählt (%3), und die erste Position in %4 (%5), bei einem Zufallsniveau von %6</translation>
    </message>
    <message>
        <source>%1. The choices differ significantly from equal proportions (%2).</source>
        <translation>%1. Die Wahlen unterscheiden sich signifikant von gleichen Anteilen (%2).</translation>
    </message>
    <message>
        <source>%1. The choices do not differ significantly from equal proportions (%2).</source>
        <translation>%1. Die Wahlen unterscheiden sich nicht signifikant von gleichen Anteilen (%2).</translation>
    </message>
    <message>
        <source>For each pair, exact sign-flip (randomisation) test of each participant&apos;s difference between the two counts (both labels exchanged within a participant), on the trials in which both were presented.</source>
        <translation>Für jedes Paar ein exakter Vorzeichen-Permutationstest der Differenz der beiden Wahlhäufigkeiten jeder Versuchsperson (beide Namen innerhalb einer Versuchsperson vertauscht), in den Durchgängen, in denen beide dargeboten wurden.</translation>
    </message>
    <message>
        <source>No choice was made between two models; collect responses first.</source>
        <translation>Zwischen zwei Modellen wurde nie gewählt; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>No pair differs significantly: %1.</source>
        <translation>Kein Paar unterscheidet sich signifikant: %1.</translation>
    </message>
    <message>
        <source>Among all pairs, %1.</source>
        <translation>Vergleich aller Paare: %1.</translation>
    </message>
    <message>
        <source>Choices (counts)</source>
        <translation>Wahlen (Anzahlen)</translation>
    </message>
    <message>
        <source>The chance level is 1/m. p: exact permutation test, one-sided, uncorrected for the number of rows: the pictures are relabelled at random once per participant, in all of the participant&apos;s trials alike. The interval contains 95 % of the permutation distribution.</source>
        <translation>Das Zufallsniveau ist 1/m. p: exakter Permutationstest, einseitig, nicht für die Anzahl der Zeilen korrigiert: Die Bilder werden je Versuchsperson einmal zufällig umbenannt, in allen ihren Durchgängen gleich. Das Intervall enthält 95 % der Permutationsverteilung.</translation>
    </message>
    <message>
        <source>Trials with all items correct: %1 of %2, on average %3 of a participant&apos;s trials (%4); permutation test over participants, %5.</source>
        <translation>Durchgänge, in denen alle Zuordnungen richtig sind: %1 von %2, im Mittel %3 der Durchgänge einer Versuchsperson (%4); Permutationstest über die Versuchspersonen, %5.</translation>
    </message>
    <message>
        <source>95 % CI of the mean: Student&apos;s t over the participants on the logit scale. In simulations with 2 to 20 participants, its coverage was at least 91 %.</source>
        <translation>95-%-KI des Mittelwerts: t-basiert über die Versuchspersonen, auf der Logit-Skala. In Simulationen mit 2 bis 20 Versuchspersonen enthielt es den wahren Mittelwert in mindestens 91 % der Studien.</translation>
    </message>
    <message>
        <source>Confusion matrix: stimulus (rows) and response (columns)</source>
        <translation>Konfusionsmatrix: Reiz (Zeilen) und Antwort (Spalten)</translation>
    </message>
    <message>
        <source>Parabolas of log estimate on log spacing, one per participant; the maximum is that of their mean, with CIs by the delta method and by Fieller&apos;s method. It is reported where the test for an interior maximum (Lind and Mehlum: the mean curve rises at the smallest and falls at the largest spacing, one-sided t tests over participants, the larger p) has p &lt; .05. R²: fit of the mean parabola to the cell means. “Descending”, “inverted U” and “other” count the participants&apos; own curves.</source>
        <translation>Parabeln der logarithmierten Schätzungen über dem logarithmierten Abstand, eine je Versuchsperson; das Maximum ist das der mittleren Parabel, mit Konfidenzintervallen nach der Delta-Methode und nach Fieller. Es ist angegeben, wenn der Test auf ein inneres Maximum (Lind und Mehlum: Die mittlere Kurve steigt beim kleinsten und fällt beim größten Abstand; einseitiger t-Test über die Versuchspersonen, das größere p) p &lt; .05 ergibt. R²: Anpassung der mittleren Parabel an die Zellmittel. „Fallend“, „umgekehrtes U“ und „andere“: Anzahlen der individuellen Kurven der Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 without a significant interior maximum (%2)</source>
        <translation>%1 ohne signifikantes inneres Maximum (%2)</translation>
    </message>
    <message>
        <source>%1 without a test for an interior maximum, because all participants have the same curve</source>
        <translation>%1 ohne Test auf ein inneres Maximum, weil alle Versuchspersonen dieselbe Kurve haben</translation>
    </message>
    <message>
        <source>The maximum of the mean of the participants&apos; parabolas, in logarithms; CI by the delta method. It is reported where the test for an interior maximum by Lind and Mehlum is significant: the mean curve rises at the smallest and falls at the largest spacing.</source>
        <translation>Das Maximum der mittleren Parabel aller Versuchspersonen, in Logarithmen; Konfidenzintervall nach der Delta-Methode. Es ist angegeben, wenn der Test auf ein inneres Maximum nach Lind und Mehlum signifikant ist: Die mittlere Kurve steigt beim kleinsten und fällt beim größten Abstand.</translation>
    </message>
    <message>
        <source>%1. This cannot be tested with one participant.</source>
        <translation>%1. Das lässt sich mit nur einer Versuchsperson nicht prüfen.</translation>
    </message>
    <message>
        <source>This cannot be tested with one participant.</source>
        <translation>Das lässt sich mit nur einer Versuchsperson nicht prüfen.</translation>
    </message>
    <message>
        <source>This cannot be tested with one participant: %1.</source>
        <translation>Das lässt sich mit nur einer Versuchsperson nicht prüfen: %1.</translation>
    </message>
    <message>
        <source>%1, uncorrected</source>
        <translation>%1, unkorrigiert</translation>
    </message>
    <message>
        <source>%1, the only test of its family</source>
        <translation>%1, der einzige Test seiner Familie</translation>
    </message>
    <message>
        <source>%1, Holm-corrected</source>
        <translation>%1, Holm-korrigiert</translation>
    </message>
    <message>
        <source>%1; the smallest attainable p is %2</source>
        <translation>%1; das kleinste erreichbare p ist %2</translation>
    </message>
    <message>
        <source>p, Holm: Holm-corrected over the %1 confirmatory tests, the family that the protocol declares (%2); a test that cannot be computed counts as p = 1.</source>
        <translation>p, Holm: Holm-korrigiert über die %1 konfirmatorischen Tests, die Familie, die das Protokoll festlegt (%2); ein nicht durchführbarer Test zählt als p = 1.</translation>
    </message>
    <message>
        <source>%1 This test is exploratory.</source>
        <translation>%1 Dieser Test ist explorativ.</translation>
    </message>
    <message>
        <source>These participants are virtual: the results serve to test the program and are not evidence about human participants.</source>
        <translation>Diese Versuchspersonen sind virtuell: Die Ergebnisse dienen der Prüfung des Programms und belegen nichts über Menschen.</translation>
    </message>
    <message>
        <source>one response</source>
        <translation>eine Antwort</translation>
    </message>
    <message>
        <source>%1 responses</source>
        <translation>%1 Antworten</translation>
    </message>
    <message>
        <source>one trial</source>
        <translation>ein Durchgang</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Durchgänge</translation>
    </message>
    <message>
        <source>without a CI</source>
        <translation>ohne KI</translation>
    </message>
    <message>
        <source>Participant-level proportions, summarised over the participants</source>
        <translation>Anteile je Versuchsperson, über die Versuchspersonen zusammengefasst</translation>
    </message>
    <message>
        <source>95 % CI: t intervals based on CR2 standard errors with the participants as clusters and Satterthwaite&apos;s degrees of freedom.</source>
        <translation>95-%-KI: t-Intervalle aus CR2-Standardfehlern mit den Versuchspersonen als Clustern; Freiheitsgrade nach Satterthwaite.</translation>
    </message>
    <message>
        <source>No CI: at least %1 participants are needed; add participants.</source>
        <translation>Kein Konfidenzintervall: Dafür sind mindestens %1 Versuchspersonen nötig; Versuchspersonen ergänzen.</translation>
    </message>
    <message>
        <source>Bradley–Terry model: of two models, i is chosen with probability 1/(1 + exp(l_j − l_i)). The log-worths l have a mean of 0; the worths sum to 1. %1</source>
        <translation>Bradley-Terry-Modell: Von zwei Modellen wird i mit der Wahrscheinlichkeit 1/(1 + exp(l_j − l_i)) gewählt. Die Log-Nutzwerte l haben den Mittelwert 0; die Nutzwerte summieren sich zu 1. %1</translation>
    </message>
    <message>
        <source>Plackett–Luce model: of several models, each is chosen in proportion to its worth. The log-worths have a mean of 0; the worths sum to 1. %1</source>
        <translation>Plackett-Luce-Modell: Von mehreren Modellen wird jedes proportional zu seinem Nutzwert gewählt. Die Log-Nutzwerte haben den Mittelwert 0; die Nutzwerte summieren sich zu 1. %1</translation>
    </message>
    <message>
        <source>Bradley–Terry model of all choices: log-worths with a mean of 0; CIs with the participants as clusters (CR2, at least %1 participants).</source>
        <translation>Bradley-Terry-Modell aller Wahlen: Log-Nutzwerte mit dem Mittelwert 0; Konfidenzintervalle mit den Versuchspersonen als Clustern (CR2, mindestens %1 Versuchspersonen).</translation>
    </message>
    <message>
        <source>Plackett–Luce model of all choices: log-worths with a mean of 0; CIs with the participants as clusters (CR2, at least %1 participants).</source>
        <translation>Plackett-Luce-Modell aller Wahlen: Log-Nutzwerte mit dem Mittelwert 0; Konfidenzintervalle mit den Versuchspersonen als Clustern (CR2, mindestens %1 Versuchspersonen).</translation>
    </message>
    <message>
        <source>Log-worths, in decreasing order: %1.</source>
        <translation>Log-Nutzwerte, in absteigender Reihenfolge: %1.</translation>
    </message>
    <message>
        <source>The protocol declares no equivalence margin, so equivalence is not assessed: %1. The data would not support equivalence within any margin: the CI reaches ±100 percentage points, the largest possible difference.</source>
        <translation>Das Protokoll legt keine Äquivalenzgrenze fest, daher wird die Äquivalenz nicht beurteilt: %1. Die Daten würden bei keiner Grenze Äquivalenz stützen: Das Konfidenzintervall reicht bis ±100 Prozentpunkte, die größte mögliche Differenz.</translation>
    </message>
    <message>
        <source>The protocol declares no equivalence margin, so equivalence is not assessed: %1. The data would support equivalence within ±%2 percentage points.</source>
        <translation>Das Protokoll legt keine Äquivalenzgrenze fest, daher wird die Äquivalenz nicht beurteilt: %1. Die Daten würden Äquivalenz innerhalb von ±%2 Prozentpunkten stützen.</translation>
    </message>
    <message>
        <source>Are women and men equivalent?</source>
        <translation>Sind Frauen und Männer äquivalent?</translation>
    </message>
    <message>
        <source>%1 is not defined</source>
        <translation>%1 ist nicht definiert</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>%1 = %2, 95 % CI [%3, %4]</source>
        <translation>%1 = %2, 95-%-KI [%3; %4]</translation>
    </message>
    <message>
        <source>Not defined: all participants have the same result in every repetition.</source>
        <translation>Nicht definiert: Alle Versuchspersonen haben in jeder Wiederholung dasselbe Ergebnis.</translation>
    </message>
    <message>
        <source>Reliability of a single repetition: %1 (consistency) and %2 (agreement); of the mean of the %3 repetitions: %4; N = %5 participants.</source>
        <translation>Reliabilität einer einzelnen Wiederholung: %1 (Konsistenz) und %2 (Übereinstimmung); des Mittelwerts der %3 Wiederholungen: %4; N = %5 Versuchspersonen.</translation>
    </message>
    <message>
        <source>How reliable are the participants&apos; results over repetitions?</source>
        <translation>Wie reliabel sind die Ergebnisse der Versuchspersonen über die Wiederholungen?</translation>
    </message>
    <message>
        <source>the participants&apos; proportions correct</source>
        <translation>die Anteile richtiger Antworten der Versuchspersonen</translation>
    </message>
    <message>
        <source>Intraclass correlations of %1 in each repetition. They are also low where participants differ little from each other.</source>
        <translation>Intraklassenkorrelationen über die Wiederholungen (Werte je Wiederholung: %1). Sie sind auch dort niedrig, wo sich die Versuchspersonen wenig voneinander unterscheiden.</translation>
    </message>
    <message>
        <source>Within-participant reliability of one of the %1 repetitions: %2; N = %3 participants.</source>
        <translation>Reliabilität einer einzelnen der %1 Wiederholungen, innerhalb der Versuchspersonen: %2; N = %3 Versuchspersonen.</translation>
    </message>
    <message>
        <source>mean ICC(3,1)</source>
        <translation>mittlere ICC(3,1)</translation>
    </message>
    <message>
        <source>the participants&apos; proportions of choices of %1</source>
        <translation>die Anteile von %1 an den Wahlen der Versuchspersonen</translation>
    </message>
    <message>
        <source>There are no responses yet; run a session first.</source>
        <translation>Es gibt noch keine Antworten; erst eine Sitzung durchführen.</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Do the conditions differ in the spacing judged roughest?</source>
        <translation>Unterscheiden sich die Bedingungen im Abstand, der als der raueste beurteilt wird?</translation>
    </message>
    <message>
        <source>Ratios of the peaks: %1.</source>
        <translation>Verhältnisse der Maxima: %1.</translation>
    </message>
    <message>
        <source>The ratio of the peaks of two conditions that both have an interior maximum, with a t-based CI over participants on the logarithmic scale.</source>
        <translation>Das Verhältnis der Maxima zweier Bedingungen, die beide ein inneres Maximum haben, mit einem t-basierten Konfidenzintervall über die Versuchspersonen auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Proportion of confusions among the responses to the two textures, all participants pooled.</source>
        <translation>Anteil der Verwechslungen an den Antworten auf die beiden Texturen, alle Versuchspersonen zusammen.</translation>
    </message>
    <message>
        <source>Proportion of confusions with each other among the responses to the two textures of a pair, all participants pooled. There is no CI, because the pair is selected as the one confused most often.</source>
        <translation>Anteil der gegenseitigen Verwechslungen an den Antworten auf die beiden Texturen eines Paars, alle Versuchspersonen zusammen. Ein Konfidenzintervall gibt es nicht, weil das Paar als das am häufigsten verwechselte ausgewählt ist.</translation>
    </message>
    <message>
        <source>The family that the protocol declares has one test (%1), the only confirmatory one; no correction is needed.</source>
        <translation>Die Familie, die das Protokoll festlegt, hat einen Test (%1), den einzigen konfirmatorischen; eine Korrektur ist nicht nötig.</translation>
    </message>
    <message>
        <source>%1 All other tests are exploratory and uncorrected. Where n counts responses or trials, they are pooled as if they were independent. %2</source>
        <translation>%1 Alle anderen Tests sind explorativ und unkorrigiert. Wo n Antworten oder Durchgänge zählt, sind sie zusammengefasst, als wären sie unabhängig. %2</translation>
    </message>
    <message>
        <source>%1 The p values of all other tests are uncorrected. Where n counts responses or trials, they are pooled as if they were independent. %2</source>
        <translation>%1 Die p-Werte aller anderen Tests sind unkorrigiert. Wo n Antworten oder Durchgänge zählt, sind sie zusammengefasst, als wären sie unabhängig. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>ε: factor by which both degrees of freedom are multiplied (Greenhouse and Geisser).</source>
        <translation>ε: Faktor, mit dem beide Freiheitsgrade multipliziert sind (Greenhouse und Geisser).</translation>
    </message>
    <message>
        <source>Brackets: 95 % CI.</source>
        <translation>In Klammern: 95-%-Konfidenzintervall (KI).</translation>
    </message>
    <message>
        <source>Estimated from trials as if they were independent: %1.</source>
        <translation>Aus Durchgängen geschätzt, als wären sie unabhängig: %1.</translation>
    </message>
    <message>
        <source>%1 Trials without a response time, which are left out: %2 of %3.</source>
        <translation>%1 Weggelassene Durchgänge ohne Reaktionszeit: %2 von %3.</translation>
    </message>
    <message>
        <source>No trial has a stored response time; collect responses first.</source>
        <translation>Für keinen Durchgang ist eine Reaktionszeit gespeichert; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>Response times by condition</source>
        <translation>Reaktionszeiten nach Bedingung</translation>
    </message>
    <message>
        <source>Learning over the trials</source>
        <translation>Lernen über die Durchgänge</translation>
    </message>
    <message>
        <source>Trend over the trials</source>
        <translation>Verlauf über die Durchgänge</translation>
    </message>
    <message>
        <source>Bayes factor of the pooled t with a Cauchy prior of scale √2/2 on the standardised difference; values below 1 favour no difference.</source>
        <translation>Bayes-Faktor des gepoolten t mit einer Cauchy-A-priori-Verteilung mit dem Skalenparameter √2/2 für die standardisierte Differenz; Werte unter 1 sprechen gegen einen Unterschied.</translation>
    </message>
    <message>
        <source>Welch&apos;s 90 % CI of the difference of the participants&apos; proportions. %1</source>
        <translation>90-%-KI nach Welch für die Differenz der Anteile der Versuchspersonen. %1</translation>
    </message>
    <message>
        <source>Two one-sided Welch t tests of the participants&apos; proportions, each at 5 %: they show equivalence where the 90 % CI lies within the margin. %1</source>
        <translation>Zwei einseitige Welch-t-Tests der Anteile der Versuchspersonen, jeweils auf dem 5-%-Niveau: Sie zeigen Äquivalenz, wenn das 90-%-KI innerhalb der Äquivalenzgrenzen liegt. %1</translation>
    </message>
    <message>
        <source>This cannot be assessed: a group has one participant, or all participants of each group have the same value.</source>
        <translation>Das lässt sich nicht beurteilen: Eine Gruppe hat nur eine Versuchsperson, oder in jeder der beiden Gruppen haben alle Versuchspersonen denselben Wert.</translation>
    </message>
    <message>
        <source>The 90 % CI lies within ±%1 percentage points: %2; two one-sided tests, %3, uncorrected. This test is exploratory.</source>
        <translation>Das 90-%-KI liegt innerhalb von ±%1 Prozentpunkten: %2; zwei einseitige Tests, %3, unkorrigiert. Dieser Test ist explorativ.</translation>
    </message>
    <message>
        <source>The 90 % CI does not lie within ±%1 percentage points: %2; two one-sided tests, %3, uncorrected. This test is exploratory.</source>
        <translation>Das 90-%-KI liegt nicht innerhalb von ±%1 Prozentpunkten: %2; zwei einseitige Tests, %3, unkorrigiert. Dieser Test ist explorativ.</translation>
    </message>
    <message>
        <source>Repeated-measures ANOVA of the log estimates, the degrees of freedom corrected by Greenhouse–Geisser ε.</source>
        <translation>Varianzanalyse mit Messwiederholung der logarithmierten Schätzungen, die Freiheitsgrade mit ε nach Greenhouse und Geisser korrigiert.</translation>
    </message>
    <message>
        <source>Repeated-measures ANOVA of the log estimates.</source>
        <translation>Varianzanalyse mit Messwiederholung der logarithmierten Schätzungen.</translation>
    </message>
    <message>
        <source>%1 Roughness ratios are computed from the participants&apos; mean log estimates; the ratio of two levels has a t-based CI, the ratio of the extremes of several levels has none.</source>
        <translation>%1 Verhältnisse der Rauheit sind aus den Mittelwerten der logarithmierten Schätzungen der Versuchspersonen berechnet; das Verhältnis zweier Stufen hat ein t-basiertes Konfidenzintervall, das der Extreme mehrerer Stufen hat keines.</translation>
    </message>
    <message>
        <source>Similarities, MDS configuration and dendrogram are based on too few confusions (between textures that were presented: %1; pairs of textures that were never confused: %2 of %3). The dissimilarities of these pairs are set by the ½ that is added to every count; collect more responses.</source>
        <translation>Ähnlichkeiten, MDS-Konfiguration und Dendrogramm beruhen auf zu wenigen Verwechslungen (zwischen dargebotenen Texturen: %1; nie verwechselte Paare von Texturen: %2 von %3). Die Unähnlichkeiten dieser Paare sind durch das ½ bestimmt, das zu jeder Anzahl addiert wird; weitere Antworten erheben.</translation>
    </message>
    <message>
        <source>With one participant there is no CI.</source>
        <translation>Bei nur einer Versuchsperson gibt es kein Konfidenzintervall.</translation>
    </message>
    <message>
        <source>Proportions of all responses pool several trials of one participant (%1 in total). The trials need not be independent: the CIs of these proportions may be too narrow, and their p values too small.</source>
        <translation>Anteile an allen Antworten fassen mehrere Durchgänge einer Versuchsperson zusammen (%1 insgesamt). Die Durchgänge sind nicht unbedingt unabhängig: Die Konfidenzintervalle dieser Anteile können zu schmal sein und ihre p-Werte zu klein.</translation>
    </message>
    <message>
        <source>Proportions of all responses pool several trials of the same participants (%1 trials of %2 participants in total). The trials need not be independent: the CIs of these proportions may be too narrow, and their p values too small. For means over the participants, the participant is the unit of analysis.</source>
        <translation>Anteile an allen Antworten fassen mehrere Durchgänge derselben Versuchspersonen zusammen (%1 Durchgänge von %2 Versuchspersonen insgesamt). Die Durchgänge sind nicht unbedingt unabhängig: Die Konfidenzintervalle dieser Anteile können zu schmal sein und ihre p-Werte zu klein. Bei Mittelwerten über die Versuchspersonen ist die Versuchsperson die Analyseeinheit.</translation>
    </message>
    <message>
        <source>%1 (N = %2)</source>
        <translation>%1 (N = %2)</translation>
    </message>
    <message>
        <source>Does the result hold for other participants and other textures of the same kind?</source>
        <translation>Gilt das Ergebnis auch für andere Versuchspersonen und andere Texturen derselben Art?</translation>
    </message>
    <message>
        <source>the proportion of correctly matched items</source>
        <translation>der Anteil richtiger Zuordnungen</translation>
    </message>
    <message>
        <source>the proportion correct</source>
        <translation>der Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>the proportion of choices of %1</source>
        <translation>der Anteil von %1 an den Wahlen</translation>
    </message>
    <message>
        <source>The items of a trial are treated as independent of each other.</source>
        <translation>Die Zuordnungen eines Durchgangs gelten als voneinander unabhängig.</translation>
    </message>
    <message>
        <source>The results are exploratory: they are not tested and not adjusted for the conditions of the trials. Each participant&apos;s counted trials are divided into halves as numbered in the plan; the middle trial of an odd number is left out, and a repeated trial keeps its planned place. Times: geometric means, and ratio of the second to the first half.</source>
        <translation>Die Ergebnisse sind explorativ: Sie werden nicht getestet und nicht für die Bedingungen der Durchgänge adjustiert. Die gezählten Durchgänge jeder Versuchsperson, nummeriert wie im Plan, werden in Hälften geteilt; bei ungerader Anzahl entfällt der mittlere, und ein wiederholter Durchgang behält seine geplante Stelle. Zeiten: geometrische Mittel und Verhältnis der zweiten zur ersten Hälfte.</translation>
    </message>
    <message>
        <source>Ratio per 10 trials: from each participant&apos;s least-squares regression of log response time on trial number.</source>
        <translation>Verhältnis je 10 Durchgänge: aus der linearen Regression der logarithmierten Reaktionszeit auf die Nummer des Durchgangs bei jeder Versuchsperson.</translation>
    </message>
    <message>
        <source>Proportions: second minus first half.</source>
        <translation>Anteile: zweite minus erste Hälfte.</translation>
    </message>
    <message>
        <source>CIs of differences of proportions are truncated at −1 and 1.</source>
        <translation>Konfidenzintervalle von Differenzen von Anteilen sind auf den Bereich von −1 bis 1 begrenzt.</translation>
    </message>
    <message>
        <source>Means over the participants, by range of counted trials; trials are numbered in the planned order across each participant&apos;s sessions. Times: geometric means.</source>
        <translation>Mittelwerte über die Versuchspersonen, getrennt nach Abschnitten der gezählten Durchgänge; die Durchgänge sind in der geplanten Reihenfolge über alle Sitzungen einer Versuchsperson nummeriert. Zeiten: geometrische Mittel.</translation>
    </message>
    <message>
        <source>Proportions refer to correctly matched items.</source>
        <translation>Anteile beziehen sich auf richtige Zuordnungen.</translation>
    </message>
    <message>
        <source>Proportions refer to correct responses.</source>
        <translation>Anteile beziehen sich auf richtige Antworten.</translation>
    </message>
    <message>
        <source>%1 The CI of the normalised mean is a within-participant CI (Cousineau and Morey): it serves to compare cells and does not include the differences between participants.</source>
        <translation>%1 Das Konfidenzintervall des normierten Mittelwerts ist ein Konfidenzintervall innerhalb der Versuchspersonen (Cousineau und Morey): Es dient dem Vergleich von Zellen und enthält die Unterschiede zwischen den Versuchspersonen nicht.</translation>
    </message>
    <message>
        <source>%1 The total of correctly matched items is compared with its exact permutation null distribution: the pictures are relabelled once per participant, in all trials alike, so that the test is also valid for participants who guess one assignment and keep it.</source>
        <translation>%1 Die Gesamtzahl richtiger Zuordnungen wird mit ihrer exakten Permutationsverteilung unter der Nullhypothese verglichen: Die Bilder werden einmal je Versuchsperson umbenannt, in allen Durchgängen gleich, sodass der Test auch für Versuchspersonen gilt, die eine Zuordnung raten und beibehalten.</translation>
    </message>
    <message>
        <source>Each participant&apos;s proportion of correctly matched items</source>
        <translation>Anteil richtiger Zuordnungen jeder Versuchsperson</translation>
    </message>
    <message>
        <source>%1 Exact permutation test: the pictures are relabelled once per participant, in all trials alike.</source>
        <translation>%1 Exakter Permutationstest: Die Bilder werden einmal je Versuchsperson umbenannt, in allen Durchgängen gleich.</translation>
    </message>
    <message>
        <source>Each participant&apos;s proportion of trials with all items correct</source>
        <translation>Anteil der Durchgänge jeder Versuchsperson, in denen alle Zuordnungen richtig sind</translation>
    </message>
    <message>
        <source>Similarity η: Luce&apos;s choice model, 1 for indistinguishable textures, with response biases separated; above 1: according to the model, confused more often than recognised. Dissimilarity: Shepard&apos;s −ln √(n_ij n_ji / (n_ii n_jj)) of the counts plus ½, not below 0; it is not the −ln of this similarity.</source>
        <translation>Ähnlichkeit η: Luces Wahlmodell, 1 für nicht unterscheidbare Texturen, um Antworttendenzen bereinigt; über 1: nach dem Modell häufiger verwechselt als erkannt. Unähnlichkeit: Shepards −ln √(n_ij n_ji / (n_ii n_jj)) der Anzahlen plus ½, nicht unter 0; sie ist nicht das −ln dieser Ähnlichkeit.</translation>
    </message>
    <message>
        <source>Each participant&apos;s proportion correct</source>
        <translation>Anteil richtiger Antworten jeder Versuchsperson</translation>
    </message>
    <message>
        <source>%1 Two-sided one-sample t test against the chance level. “Cannot tell” responses name no picture and are left out here; in the table of proportions they count as incorrect.</source>
        <translation>%1 Zweiseitiger Einstichproben-t-Test gegen das Zufallsniveau. Antworten „kann es nicht sagen“ geben kein Bild an und sind hier weggelassen; in der Tabelle der Anteile zählen sie als falsch.</translation>
    </message>
    <message>
        <source>%1 One-sided exact binomial test against the chance level. “Cannot tell” responses name no picture and are left out here; in the table of proportions they count as incorrect.</source>
        <translation>%1 Einseitiger exakter Binomialtest gegen das Zufallsniveau. Antworten „kann es nicht sagen“ geben kein Bild an und sind hier weggelassen; in der Tabelle der Anteile zählen sie als falsch.</translation>
    </message>
    <message>
        <source>Response times are measured from the cue (the first question after the last surface) to the response and include repeated presentations. Geometric means over participants of each participant&apos;s geometric mean.</source>
        <translation>Reaktionszeiten werden vom Signal (der ersten Frage nach der letzten Oberfläche) bis zur Antwort gemessen, einschließlich wiederholter Darbietungen. Geometrische Mittel über die Versuchspersonen aus dem geometrischen Mittel jeder Versuchsperson.</translation>
    </message>
    <message>
        <source>%1 Equal choice probabilities are tested by a within-participant permutation test: the models are exchanged within each participant&apos;s choices, so that the test is valid however the choices of a participant depend on each other.</source>
        <translation>%1 Gleiche Wahlwahrscheinlichkeiten werden mit einem Permutationstest innerhalb der Versuchspersonen geprüft: Die Modelle werden innerhalb der Wahlen jeder Versuchsperson vertauscht, sodass der Test unabhängig davon gültig ist, wie die Wahlen einer Versuchsperson voneinander abhängen.</translation>
    </message>
    <message>
        <source>Each participant&apos;s proportion of choices</source>
        <translation>Anteil an den Wahlen jeder Versuchsperson</translation>
    </message>
    <message>
        <source>Means of the participants&apos; own results.</source>
        <translation>Mittelwerte der individuellen Ergebnisse der Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 The CIs of the means are t-based, for proportions on the logit scale; that of the difference is Welch&apos;s CI. p is computed by a different method: in borderline cases p may be below .05 although the CI contains 0, or the reverse.</source>
        <translation>%1 Die Konfidenzintervalle der Mittelwerte sind t-basiert, für Anteile auf der Logit-Skala; für die Differenz gilt das Konfidenzintervall nach Welch. p ist nach einem anderen Verfahren berechnet: In Grenzfällen kann p unter .05 liegen, obwohl das Konfidenzintervall 0 enthält, oder umgekehrt.</translation>
    </message>
    <message>
        <source>%1, averaged over the participants, with a t-based CI on the logit scale.</source>
        <translation>%1, gemittelt über die Versuchspersonen, mit einem t-basierten Konfidenzintervall auf der Logit-Skala.</translation>
    </message>
    <message>
        <source>%1, averaged over the participants.</source>
        <translation>%1, gemittelt über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>95 % CI: t-based over participants, on the logarithmic scale.</source>
        <translation>95-%-KI: t-basiert über die Versuchspersonen, auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>No test of the family (%1) could be computed.</source>
        <translation>Kein Test der Familie (%1) ließ sich durchführen.</translation>
    </message>
    <message>
        <source>%1 The CIs assume normally distributed results. In simulations of proportions of 2 to 20 participants, their coverage was at least 86 % with a mean of 25 to 71 %, and at least 58 % with a mean of 87 or 95 %.</source>
        <translation>%1 Die Konfidenzintervalle setzen normalverteilte Ergebnisse voraus. In Simulationen von Anteilen bei 2 bis 20 Versuchspersonen enthielten sie den wahren Wert in mindestens 86 % der Studien mit einem Mittelwert von 25 bis 71 % und in mindestens 58 % derjenigen mit einem Mittelwert von 87 oder 95 %.</translation>
    </message>
    <message>
        <source>%1 95 % CI: t-based over participants, on the logarithmic scale; in simulations with 2 to 20 participants, its coverage was at least 92 %.</source>
        <translation>%1 95-%-KI: t-basiert über die Versuchspersonen, auf der logarithmischen Skala; in Simulationen mit 2 bis 20 Versuchspersonen enthielt es den wahren Wert in mindestens 92 % der Studien.</translation>
    </message>
    <message>
        <source>95 % CI: t-based over participants, for times on the logarithmic scale; in simulations with 2 to 20 participants, its coverage was at least 92 %.</source>
        <translation>95-%-KI: t-basiert über die Versuchspersonen, bei Zeiten auf der logarithmischen Skala; in Simulationen mit 2 bis 20 Versuchspersonen enthielt es den wahren Wert in mindestens 92 % der Studien.</translation>
    </message>
    <message>
        <source>95 % CI: t-based over participants, for times on the logarithmic and for proportions on the logit scale; in simulations with 2 to 20 participants and proportions of 5 to 98 %, its coverage was at least 90 %.</source>
        <translation>95-%-KI: t-basiert über die Versuchspersonen, bei Zeiten auf der logarithmischen, bei Anteilen auf der Logit-Skala; in Simulationen mit 2 bis 20 Versuchspersonen und Anteilen von 5 bis 98 % enthielt es den wahren Mittelwert in mindestens 90 % der Studien.</translation>
    </message>
    <message>
        <source>For a participant and a texture with random intercepts of 0, %1 is estimated as %2 (%3), compared with a chance level of %4: t(%5) = %6, %7, uncorrected. SD of the intercepts (logit): participants %8, textures %9. This test is exploratory.</source>
        <translation>Für eine Versuchsperson und eine Textur mit zufälligen Achsenabschnitten von 0 wird %1 auf %2 geschätzt (%3), bei einem Zufallsniveau von %4: t(%5) = %6, %7, unkorrigiert. SD der Achsenabschnitte (Logit): Versuchspersonen %8, Texturen %9. Dieser Test ist explorativ.</translation>
    </message>
    <message>
        <source>%1 was rougher than %2 by a factor of %3 (%4 % CI [%5, %6])</source>
        <translation>%1 war um den Faktor %3 rauer als %2 (%4-%-KI [%5; %6])</translation>
    </message>
    <message>
        <source>%1 at %2 (95 % CI [%3, %4]; test for an interior maximum %5; R² of the mean parabola %6)</source>
        <translation>%1 bei %2 (95-%-KI [%3; %4]; Test auf ein inneres Maximum %5; R² der mittleren Parabel %6)</translation>
    </message>
    <message>
        <source>the peak of %1 is at %2 times the spacing of the peak of %3 (95 % CI [%4, %5])</source>
        <translation>das Maximum von %1 liegt beim %2-Fachen des Abstands des Maximums von %3 (95-%-KI [%4; %5])</translation>
    </message>
    <message>
        <source>d′ = %1, 95 % CI [%2, %3], n = %4 responses</source>
        <translation>d′ = %1, 95-%-KI [%2; %3], n = %4 Antworten</translation>
    </message>
    <message>
        <source>95 % CI [%1, %2]</source>
        <translation>95-%-KI [%1; %2]</translation>
    </message>
    <message>
        <source>Welch 95 % CI [%1, %2]</source>
        <translation>Welch-95-%-KI [%1; %2]</translation>
    </message>
    <message>
        <source>Geometric means of the estimates. normalised: each participant&apos;s scale removed (the mean of the logarithms of all cells). raw: not normalised. left out: number of participants without an estimate in some cell; only raw includes them.</source>
        <translation>Geometrische Mittel der Schätzungen. normiert: ohne die Skala jeder Versuchsperson (den Mittelwert der Logarithmen aller Zellen). roh: nicht normiert. weggelassen: Anzahl der Versuchspersonen, denen in einer Zelle eine Schätzung fehlt; nur „roh“ enthält sie.</translation>
    </message>
    <message>
        <source>For this participant only: %1 of the items were matched correctly (%2), compared with a chance level of %3; permutation test, %4. More participants are needed.</source>
        <translation>Nur für diese Versuchsperson: %1 der Zuordnungen waren richtig (%2), bei einem Zufallsniveau von %3; Permutationstest, %4. Es werden mehr Versuchspersonen benötigt.</translation>
    </message>
    <message>
        <source>For this participant only: %1 of the responses were correct (%2), compared with a chance level of %3; %4. More participants are needed.</source>
        <translation>Nur für diese Versuchsperson: %1 der Antworten waren richtig (%2), bei einem Zufallsniveau von %3; %4. Es werden mehr Versuchspersonen benötigt.</translation>
    </message>
    <message>
        <source>magnitude estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>picture matching</source>
        <translation>Bildzuordnung</translation>
    </message>
    <message>
        <source>absolute identification</source>
        <translation>absolute Identifikation</translation>
    </message>
    <message>
        <source>best-of-n choice</source>
        <translation>Auswahl der besten aus n</translation>
    </message>
    <message>
        <source>difference (%6 − %7) = %1 percentage points, 90 % CI [%2, %3], N = %4 participants; JZS Bayes factor for a difference BF₁₀ = %5</source>
        <translation>Differenz (%6 − %7) = %1 Prozentpunkte, 90-%-KI [%2; %3], N = %4 Versuchspersonen; JZS-Bayes-Faktor für einen Unterschied BF₁₀ = %5</translation>
    </message>
    <message>
        <source>the mean proportion correct is %1 for %3 and %2 for %4</source>
        <translation>mittlerer Anteil richtiger Antworten – %3 %1, %4 %2</translation>
    </message>
    <message>
        <source>the mean proportion of correctly matched items is %1 for %3 and %2 for %4</source>
        <translation>mittlerer Anteil richtiger Zuordnungen – %3 %1, %4 %2</translation>
    </message>
    <message>
        <source>the mean number of correctly matched items per trial is %1 for %3 and %2 for %4</source>
        <translation>mittlere Anzahl richtiger Zuordnungen je Durchgang – %3 %1, %4 %2</translation>
    </message>
    <message>
        <source>the mean proportion of choices of %5 is %1 for %3 and %2 for %4</source>
        <translation>mittlerer Anteil von %5 an den Wahlen – %3 %1, %4 %2</translation>
    </message>
    <message>
        <source>women</source>
        <translation>Frauen</translation>
    </message>
    <message>
        <source>men</source>
        <translation>Männer</translation>
    </message>
    <message>
        <source>Do the groups %1 and %2 differ?</source>
        <translation>Unterscheiden sich die Gruppen %1 und %2?</translation>
    </message>
    <message>
        <source>Are the groups %1 and %2 equivalent?</source>
        <translation>Sind die Gruppen %1 und %2 äquivalent?</translation>
    </message>
    <message>
        <source>rating</source>
        <translation>Beurteilung</translation>
    </message>
    <message>
        <source>Principal components of the scales</source>
        <translation>Hauptkomponenten der Skalen</translation>
    </message>
    <message>
        <source>Loadings of the scales and scores of the items</source>
        <translation>Ladungen der Skalen und Komponentenwerte der Items</translation>
    </message>
    <message>
        <source>%1 (95 % CI [%2, %3])</source>
        <translation>%1 (95-%-KI [%2; %3])</translation>
    </message>
    <message>
        <source>Do the ratings on the scale “%1” differ between the items?</source>
        <translation>Unterscheiden sich die Urteile auf der Skala „%1“ zwischen den Items?</translation>
    </message>
    <message>
        <source>Friedman test of the participants&apos; mean ratings of the items; CIs of the means are t-based.</source>
        <translation>Friedman-Test der mittleren Urteile der Versuchspersonen über die Items; die Konfidenzintervalle der Mittelwerte sind t-basiert.</translation>
    </message>
    <message>
        <source>Not tested: too few participants rated every item.</source>
        <translation>Nicht getestet: Zu wenige Versuchspersonen haben alle Items beurteilt.</translation>
    </message>
    <message>
        <source>Mean ratings of the items on each scale</source>
        <translation>Mittlere Urteile über die Items auf jeder Skala</translation>
    </message>
    <message>
        <source>Means of the participants&apos; mean ratings, over the participants who rated every item, with t-based 95 % CIs; mean rank: 1 for a participant&apos;s lowest rating.</source>
        <translation>Mittelwerte der mittleren Urteile über die Versuchspersonen, die alle Items beurteilt haben, mit t-basierten 95-%-KI; mittlerer Rang: 1 für das niedrigste Urteil einer Versuchsperson.</translation>
    </message>
    <message>
        <source>Agreement of the participants on each scale</source>
        <translation>Übereinstimmung der Versuchspersonen auf jeder Skala</translation>
    </message>
    <message>
        <source>Cumulative link mixed model of the ratings on each scale</source>
        <translation>Kumulatives gemischtes Link-Modell der Urteile auf jeder Skala</translation>
    </message>
    <message>
        <source>paired comparison</source>
        <translation>Paarvergleich</translation>
    </message>
    <message>
        <source>Choices of each item in comparisons with each other item</source>
        <translation>Wahlen jedes Items in den Vergleichen mit jedem anderen</translation>
    </message>
    <message>
        <source>Ties are left out. The chance level is 1/2. p: exact binomial test, two-sided, uncorrected, all responses treated as independent.</source>
        <translation>Ohne Gleichstände. Das Zufallsniveau ist 1/2. p: exakter Binomialtest, zweiseitig, unkorrigiert; alle Antworten gelten als unabhängig.</translation>
    </message>
    <message>
        <source>Ties</source>
        <translation>Gleichstände</translation>
    </message>
    <message>
        <source>Proportion of the comparisons in which each item was chosen</source>
        <translation>Anteil der Vergleiche, in denen jedes Item gewählt wurde</translation>
    </message>
    <message>
        <source>The items on one scale</source>
        <translation>Die Items auf einer Skala</translation>
    </message>
    <message>
        <source>Bradley–Terry model without ties: of two items, i is chosen with probability 1/(1 + exp(l_j − l_i)). The log-worths l have a mean of 0; the worths sum to 1. %1</source>
        <translation>Bradley-Terry-Modell ohne Gleichstände: Von zwei Items wird i mit der Wahrscheinlichkeit 1/(1 + exp(l_j − l_i)) gewählt. Die Log-Nutzwerte l haben den Mittelwert 0; die Nutzwerte summieren sich zu 1. %1</translation>
    </message>
    <message>
        <source>Order effect, ties and goodness of fit of the scale</source>
        <translation>Reihenfolgeeffekt, Gleichstände und Anpassungsgüte der Skala</translation>
    </message>
    <message>
        <source>Consistency of the participants</source>
        <translation>Konsistenz der Versuchspersonen</translation>
    </message>
    <message>
        <source>Are some items chosen more often than others?</source>
        <translation>Werden manche Items häufiger gewählt als andere?</translation>
    </message>
    <message>
        <source>Friedman test of each participant&apos;s proportion of the comparisons in which an item was chosen, a tie counting half; CIs of the means are t-based.</source>
        <translation>Friedman-Test des Anteils der Vergleiche, in denen eine Versuchsperson ein Item gewählt hat; ein Gleichstand zählt halb; die Konfidenzintervalle der Mittelwerte sind t-basiert.</translation>
    </message>
    <message>
        <source>Do the items lie on one scale?</source>
        <translation>Liegen die Items auf einer Skala?</translation>
    </message>
    <message>
        <source>ζ = %1</source>
        <translation>ζ = %1</translation>
    </message>
    <message>
        <source>Are the participants&apos; choices consistent?</source>
        <translation>Sind die Wahlen der Versuchspersonen konsistent?</translation>
    </message>
    <message>
        <source>Mean coefficient of consistence: %1. It is 1 without circular triads, and %2 on average under guessing.</source>
        <translation>Mittlerer Konsistenzkoeffizient: %1. Er beträgt 1 ohne zirkuläre Triaden und im Mittel %2 beim Raten.</translation>
    </message>
    <message>
        <source>Kendall’s ζ of each complete round without ties, averaged over the rounds of a participant; the CI of the mean is t-based.</source>
        <translation>Kendalls ζ jeder vollständigen Runde ohne Gleichstände, gemittelt über die Runden einer Versuchsperson; das Konfidenzintervall des Mittelwerts ist t-basiert.</translation>
    </message>
    <message>
        <source>Fewer than two items were presented, so that no comparison is possible; present at least two items.</source>
        <translation>Es wurden weniger als zwei Items dargeboten, daher ist kein Vergleich möglich; mindestens zwei Items darbieten.</translation>
    </message>
    <message>
        <source>Which item of a pair is chosen more often?</source>
        <translation>Welches Item eines Paars wird häufiger gewählt?</translation>
    </message>
    <message>
        <source>For each pair, exact sign-flip (randomisation) test of each participant&apos;s difference between the two counts (both labels exchanged within a participant); ties are left out.</source>
        <translation>Für jedes Paar ein exakter Vorzeichen-Permutationstest der Differenz der beiden Wahlhäufigkeiten jeder Versuchsperson (beide Namen innerhalb einer Versuchsperson vertauscht); ohne Gleichstände.</translation>
    </message>
    <message>
        <source>No choice was made between two items; collect responses first.</source>
        <translation>Zwischen zwei Items wurde nie gewählt; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>Permutation test of the numbers of choices of the two positions, which are exchanged within each participant; ties are left out.</source>
        <translation>Permutationstest der Wahlhäufigkeiten der beiden Positionen, die innerhalb jeder Versuchsperson vertauscht werden; ohne Gleichstände.</translation>
    </message>
    <message>
        <source>Bradley–Terry model with an order effect and ties</source>
        <translation>Bradley-Terry-Modell mit Reihenfolgeeffekt und Gleichständen</translation>
    </message>
    <message>
        <source>Bradley–Terry model with an order effect</source>
        <translation>Bradley-Terry-Modell mit Reihenfolgeeffekt</translation>
    </message>
    <message>
        <source>Bradley–Terry model with ties</source>
        <translation>Bradley-Terry-Modell mit Gleichständen</translation>
    </message>
    <message>
        <source>Bradley–Terry model</source>
        <translation>Bradley-Terry-Modell</translation>
    </message>
    <message>
        <source>The comparisons differ significantly from the %1: %2, %3. Values on one scale do not describe them completely.</source>
        <translation>Die Vergleiche weichen signifikant vom %1 ab: %2, %3. Werte auf einer Skala beschreiben sie nicht vollständig.</translation>
    </message>
    <message>
        <source>The comparisons do not differ significantly from the %1: %2, %3.</source>
        <translation>Die Vergleiche weichen nicht signifikant vom %1 ab: %2, %3.</translation>
    </message>
    <message>
        <source>The scales</source>
        <translation>Die Skalen</translation>
    </message>
    <message>
        <source>The ends of each scale as numbers and as labelled for participants; a scale without points is a continuous line.</source>
        <translation>Die Enden jeder Skala als Zahlen und mit den Beschriftungen, die die Versuchspersonen sehen; eine Skala ohne Stufen ist eine durchgehende Linie.</translation>
    </message>
    <message>
        <source>Participants who never chose the target cannot contribute to the test of textures and are not counted in its n</source>
        <translation>Versuchspersonen, die das Ziel nie gewählt haben, können zum Test der Texturen nichts beitragen und sind in seinem n nicht enthalten</translation>
    </message>
    <message>
        <source>The protocol declares only tests of its other tasks, so that no test of this one is confirmatory.</source>
        <translation>Das Protokoll legt nur Tests seiner anderen Aufgaben fest; daher ist kein Test dieser Aufgabe konfirmatorisch.</translation>
    </message>
    <message>
        <source>The protocol declares no family of tests, so that no test is confirmatory.</source>
        <translation>Das Protokoll legt keine Familie von Tests fest; daher ist kein Test konfirmatorisch.</translation>
    </message>
    <message>
        <source>%1 The default family of this kind of protocol has one test (%2); no correction is needed.</source>
        <translation>%1 Die Standardfamilie dieser Art von Protokoll hat einen Test (%2); eine Korrektur ist nicht nötig.</translation>
    </message>
    <message>
        <source>%1 p, Holm: Holm-corrected over the %2 tests of the default family of this kind of protocol (%3); a test that cannot be computed counts as p = 1.</source>
        <translation>%1 p, Holm: Holm-korrigiert über die %2 Tests der Standardfamilie dieser Art von Protokoll (%3); ein nicht durchführbarer Test zählt als p = 1.</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4.</source>
        <translation>%1 %2: %3 von %4.</translation>
    </message>
    <message>
        <source>The position is the place of a surface in the order of presentation. Ties are left out.</source>
        <translation>Die Position ist der Platz einer Oberfläche in der Reihenfolge der Darbietung. Ohne Gleichstände.</translation>
    </message>
    <message>
        <source>The items cannot be placed on a scale by maximum likelihood: some of them were always or never chosen in the comparisons with the others, or were never compared with them, so that their distance has no finite estimate. Collect more comparisons of these items.</source>
        <translation>Die Items lassen sich nicht durch Maximum-Likelihood-Schätzung auf einer Skala anordnen: Einige wurden in den Vergleichen mit den anderen immer oder nie gewählt oder nie mit ihnen verglichen, sodass es für ihren Abstand keine endliche Schätzung gibt. Mehr Vergleiche dieser Items erheben.</translation>
    </message>
    <message>
        <source>%1, by maximum likelihood (Davidson and Beaver 1977), with Wald 95 % CIs and likelihood-ratio tests. All responses are treated as independent, although those of one participant may not be: the p values are approximate.</source>
        <translation>%1, Maximum-Likelihood-Schätzung (Davidson und Beaver 1977) mit 95-%-KI nach Wald und Likelihood-Quotienten-Tests. Alle Antworten werden als unabhängig behandelt, obwohl die einer Versuchsperson abhängig sein können: Die p-Werte sind Näherungen.</translation>
    </message>
    <message>
        <source>Order effect: increase in the log odds of being chosen for the item presented first.</source>
        <translation>Reihenfolgeeffekt: Zunahme der logarithmierten Odds, gewählt zu werden, für das zuerst dargebotene Item.</translation>
    </message>
    <message>
        <source>Ties: ln ν, where ν is the odds of a tie between equal items, relative to the choice of one of them.</source>
        <translation>Gleichstände: ln ν, wobei ν die Odds eines Gleichstands zwischen gleichen Items gegenüber der Wahl eines von ihnen sind.</translation>
    </message>
    <message>
        <source>A round is one comparison of every pair, with the same levels of all other factors; rounds with a tie or without one of the pairs are left out. A triad is circular if a is chosen over b, b over c, and c over a: number per round. ζ, the coefficient of consistence: 1 without circular triads, 0 with as many as possible, %1 on average under guessing. p: exact probability of at most as many circular triads in these rounds under guessing, uncorrected.</source>
        <translation>Eine Runde ist ein Vergleich jedes Paars mit denselben Stufen aller anderen Faktoren; Runden mit einem Gleichstand oder ohne eines der Paare bleiben unberücksichtigt. Eine Triade ist zirkulär, wenn a gegenüber b, b gegenüber c und c gegenüber a gewählt wird: Anzahl pro Runde. ζ, der Konsistenzkoeffizient: 1 ohne zirkuläre Triaden, 0 bei der größtmöglichen Zahl, im Mittel %1 beim Raten. p: exakte Wahrscheinlichkeit für höchstens so viele zirkuläre Triaden in diesen Runden beim Raten, unkorrigiert.</translation>
    </message>
    <message>
        <source>Not tested: fewer than two participants compared every pair equally often.</source>
        <translation>Nicht getestet: Weniger als zwei Versuchspersonen haben jedes Paar gleich häufig verglichen.</translation>
    </message>
    <message>
        <source>No: all items were chosen equally often. Friedman test: %1.</source>
        <translation>Nein: Alle Items wurden gleich häufig gewählt. Friedman-Test: %1.</translation>
    </message>
    <message>
        <source>Participants who tied %1 and %2 in every comparison are left out of the test of this pair</source>
        <translation>Versuchspersonen, die bei %1 und %2 immer Gleichstand angegeben haben, bleiben im Test dieses Paars unberücksichtigt</translation>
    </message>
    <message>
        <source>no CI, because all participants have the same value</source>
        <translation>kein Konfidenzintervall, weil alle Versuchspersonen denselben Wert haben</translation>
    </message>
    <message>
        <source>Participants without both correct and incorrect responses are left out of the test of the ratings on “%1”</source>
        <translation>Versuchspersonen, die nicht sowohl richtige als auch falsche Antworten gegeben haben, fehlen im Test der Urteile auf „%1“</translation>
    </message>
    <message>
        <source>The mean rating is %1 over all trials.</source>
        <translation>Das mittlere Urteil über alle Durchgänge ist %1.</translation>
    </message>
    <message>
        <source>No response was correct.</source>
        <translation>Keine Antwort war richtig.</translation>
    </message>
    <message>
        <source>No response was incorrect.</source>
        <translation>Keine Antwort war falsch.</translation>
    </message>
    <message>
        <source>The mean rating is %1 for correct responses and %2 for incorrect ones.</source>
        <translation>Das mittlere Urteil ist %1 bei richtigen und %2 bei falschen Antworten.</translation>
    </message>
    <message>
        <source>%1 The difference could not be tested.</source>
        <translation>%1 Der Unterschied konnte nicht getestet werden.</translation>
    </message>
    <message>
        <source>Ratings that accompany another question</source>
        <translation>Urteile, die eine andere Frage begleiten</translation>
    </message>
    <message>
        <source>Means of the participants&apos; mean ratings over such trials, of the participants who have any, with t-based 95 % CIs; difference: of the participants who have both correct and incorrect responses.</source>
        <translation>Mittelwerte der mittleren Urteile der Versuchspersonen über solche Durchgänge, über die Versuchspersonen mit solchen Durchgängen, mit t-basierten 95-%-KI; Differenz: über die Versuchspersonen mit richtigen und falschen Antworten.</translation>
    </message>
    <message>
        <source>Do the ratings on the scale “%1” differ between correct and incorrect responses to the question “%2”?</source>
        <translation>Unterscheiden sich die Urteile auf der Skala „%1“ zwischen richtigen und falschen Antworten auf die Frage „%2“?</translation>
    </message>
    <message>
        <source>How high are the ratings on the scale “%1”, which accompanies the question “%2”?</source>
        <translation>Wie hoch sind die Urteile auf der Skala „%1“, die die Frage „%2“ begleitet?</translation>
    </message>
    <message>
        <source>Means of the participants&apos; mean ratings, with t-based CIs; a paired t test compares correct and incorrect responses.</source>
        <translation>Mittelwerte der mittleren Urteile der Versuchspersonen mit t-basierten KI; ein t-Test für gepaarte Stichproben vergleicht richtige und falsche Antworten.</translation>
    </message>
    <message>
        <source>%1 The p values of the tests are uncorrected. Where n counts responses or trials, they are pooled as if they were independent. %2</source>
        <translation>%1 Die p-Werte der Tests sind unkorrigiert. Wo n Antworten oder Durchgänge zählt, sind sie zusammengefasst, als wären sie unabhängig. %2</translation>
    </message>
    <message>
        <source>Participants without an estimate of the %1 in every condition are left out of the test of the conditions</source>
        <translation>Versuchspersonen ohne Schätzung (%1) in jeder Bedingung gehen nicht in den Test der Bedingungen ein</translation>
    </message>
    <message>
        <source>The protocol does not state the judgement and the parameter that is varied with its value in the standard, so that thresholds cannot be estimated; state them in a new version of the protocol.</source>
        <translation>Das Protokoll nennt nicht das Urteil und den variierten Parameter mit seinem Wert im Standardreiz, daher können keine Schwellen geschätzt werden; beides in einer neuen Version des Protokolls angeben.</translation>
    </message>
    <message>
        <source>%1, Weber fraction %2</source>
        <translation>%1, Weber-Bruch %2</translation>
    </message>
    <message>
        <source>%1, n = %2</source>
        <translation>%1, n = %2</translation>
    </message>
    <message>
        <source>What is the detection threshold of the %1?</source>
        <translation>Wie groß ist die Wahrnehmungsschwelle des Parameters %1?</translation>
    </message>
    <message>
        <source>How large is the just-noticeable difference of the %1?</source>
        <translation>Wie groß ist die Unterschiedsschwelle des Parameters %1?</translation>
    </message>
    <message>
        <source>It could not be estimated: no participant has a threshold within the presented levels.</source>
        <translation>Sie konnte nicht geschätzt werden: Bei keiner Versuchsperson liegt die Schwelle innerhalb der dargebotenen Stufen.</translation>
    </message>
    <message>
        <source>Is the point of subjective equality different from the standard?</source>
        <translation>Weicht der Punkt der subjektiven Gleichheit vom Standardreiz ab?</translation>
    </message>
    <message>
        <source>Wilcoxon signed-rank test of the participants&apos; points of subjective equality against the standard.</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test der Punkte der subjektiven Gleichheit der Versuchspersonen gegen den Standardreiz.</translation>
    </message>
    <message>
        <source>It could not be estimated: no participant has a point of subjective equality within the presented levels.</source>
        <translation>Er konnte nicht geschätzt werden: Bei keiner Versuchsperson liegt der Punkt der subjektiven Gleichheit innerhalb der dargebotenen Stufen.</translation>
    </message>
    <message>
        <source>Mean point of subjective equality: %1; standard: %2.</source>
        <translation>Mittlerer Punkt der subjektiven Gleichheit: %1; Standardreiz: %2.</translation>
    </message>
    <message>
        <source>Do the thresholds differ between the conditions?</source>
        <translation>Unterscheiden sich die Schwellen zwischen den Bedingungen?</translation>
    </message>
    <message>
        <source>Not tested: fewer than two participants have a threshold in every condition.</source>
        <translation>Nicht getestet: Weniger als zwei Versuchspersonen haben in jeder Bedingung eine Schwelle.</translation>
    </message>
    <message>
        <source>Does the order of presentation matter?</source>
        <translation>Spielt die Reihenfolge der Darbietung eine Rolle?</translation>
    </message>
    <message>
        <source>Wilcoxon signed-rank test of each participant&apos;s proportions of choices of the comparison presented first and second.</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test der Anteile, mit denen jede Versuchsperson den Vergleichsreiz wählte, wenn er zuerst und wenn er als Zweites dargeboten wurde.</translation>
    </message>
    <message>
        <source>This cannot be estimated: no participant felt the comparison in both positions.</source>
        <translation>Das kann nicht geschätzt werden: Keine Versuchsperson fühlte den Vergleichsreiz an beiden Positionen.</translation>
    </message>
    <message>
        <source>%1 percentage points</source>
        <translation>%1 Prozentpunkte</translation>
    </message>
    <message>
        <source>the difference between the proportions of choices of the comparison, presented first minus presented second, was %1</source>
        <translation>die Differenz der Anteile der Wahlen des Vergleichsreizes, zuerst minus als Zweites dargeboten, betrug %1</translation>
    </message>
    <message>
        <source>Not tested: %1.</source>
        <translation>Nicht getestet: %1.</translation>
    </message>
    <message>
        <source>Mean thresholds</source>
        <translation>Mittlere Schwellen</translation>
    </message>
    <message>
        <source>Means over the participants whose threshold could be estimated, with t-based 95 % CIs.</source>
        <translation>Mittelwerte über die Versuchspersonen, deren Schwelle geschätzt werden konnte, mit 95-%-KIs nach der t-Verteilung.</translation>
    </message>
    <message>
        <source>Thresholds of the participants</source>
        <translation>Schwellen der Versuchspersonen</translation>
    </message>
    <message>
        <source>Responses by level</source>
        <translation>Antworten je Stufe</translation>
    </message>
    <message>
        <source>Hits are correct responses.</source>
        <translation>Treffer sind richtige Antworten.</translation>
    </message>
    <message>
        <source>Hits are choices of the standard, because the comparison was chosen less often at higher levels.</source>
        <translation>Treffer sind Wahlen des Standardreizes, weil der Vergleichsreiz bei höheren Stufen seltener gewählt wurde.</translation>
    </message>
    <message>
        <source>Hits are choices of the comparison.</source>
        <translation>Treffer sind Wahlen des Vergleichsreizes.</translation>
    </message>
    <message>
        <source>Choices of the comparison by its position</source>
        <translation>Wahlen des Vergleichsreizes nach seiner Position</translation>
    </message>
    <message>
        <source>discrimination</source>
        <translation>Unterscheidung</translation>
    </message>
    <message>
        <source>Trials of each track</source>
        <translation>Durchgänge jeder Folge (Track)</translation>
    </message>
    <message>
        <source>Trials whose level was chosen by a procedure from the responses, by track and in order of presentation.</source>
        <translation>Die Durchgänge, deren Stufe ein Verfahren aus den Antworten wählte, nach Folge (Track) und in der Reihenfolge der Darbietung.</translation>
    </message>
    <message>
        <source>It is uncertain whether choices of the comparison increase or decrease with the level: their covariance with the level is not significantly different from 0 (α = .05). The psychometric functions may count the choices of the other surface; collect more responses.</source>
        <translation>Es ist unsicher, ob die Wahlen des Vergleichsreizes mit der Stufe zu- oder abnehmen: Ihre Kovarianz mit der Stufe unterscheidet sich nicht signifikant von 0 (α = 0,05). Die psychometrischen Funktionen zählen möglicherweise die Wahlen der anderen Oberfläche; weitere Antworten erheben.</translation>
    </message>
    <message>
        <source>Not tested: no participant has trials in every condition, and this test compares conditions within participants.</source>
        <translation>Nicht getestet: Keine Versuchsperson hat Durchgänge in allen Bedingungen, und dieser Test vergleicht Bedingungen innerhalb der Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 Not stored by these sessions: %2.</source>
        <translation>%1 In diesen Sitzungen nicht gespeichert: %2.</translation>
    </message>
    <message>
        <source>Exploration by condition: times and strokes</source>
        <translation>Exploration nach Bedingung: Zeiten und Striche</translation>
    </message>
    <message>
        <source>Exploration by condition: force and speed</source>
        <translation>Exploration nach Bedingung: Kraft und Geschwindigkeit</translation>
    </message>
    <message>
        <source>Contact times and response times: linear mixed models</source>
        <translation>Kontaktdauern und Reaktionszeiten: lineare gemischte Modelle</translation>
    </message>
    <message>
        <source>%1 changes by a factor of %2 per 10 trials of a block, 95 % CI [%3, %4].</source>
        <translation>%1 ändert sich je 10 Durchgänge eines Blocks um den Faktor %2, 95-%-KI [%3; %4].</translation>
    </message>
    <message>
        <source>%1 changes by a factor of %2 from block to block, 95 % CI [%3, %4].</source>
        <translation>%1 ändert sich von Block zu Block um den Faktor %2, 95-%-KI [%3; %4].</translation>
    </message>
    <message>
        <source>%1 changes by a factor of %2 from session to session, 95 % CI [%3, %4].</source>
        <translation>%1 ändert sich von Sitzung zu Sitzung um den Faktor %2, 95-%-KI [%3; %4].</translation>
    </message>
    <message>
        <source>%1 %2: the intraclass correlation is %3.</source>
        <translation>%1 %2: Die Intraklassenkorrelation beträgt %3.</translation>
    </message>
    <message>
        <source>%1 %2: measurements without a time above 0, which are left out: %3.</source>
        <translation>%1 %2: Messungen ohne Zeit über 0, die ausgelassen sind: %3.</translation>
    </message>
    <message>
        <source>Contact time</source>
        <translation>Die Kontaktdauer</translation>
    </message>
    <message>
        <source>Response time</source>
        <translation>Die Reaktionszeit</translation>
    </message>
    <message>
        <source>The mean and the SD of each surface are computed over the time in contact. The table shows the mean (SD) over the participants of each participant’s mean over the surfaces.</source>
        <translation>Mittelwert und SD je Oberfläche sind über die Zeit im Kontakt berechnet. Die Tabelle zeigt den Mittelwert (SD) über die Versuchspersonen von deren Mittelwerten über die Oberflächen.</translation>
    </message>
    <message>
        <source>For each participant, the median of times and the mean of other quantities are computed over surfaces (for response times: over trials). The table shows the median [quartiles] or the mean (SD) of these values over the participants.</source>
        <translation>Für jede Versuchsperson sind der Median von Zeiten und der Mittelwert anderer Größen über die Oberflächen berechnet (bei Reaktionszeiten: über die Durchgänge). Die Tabelle zeigt den Median [Quartile] oder den Mittelwert (SD) dieser Werte über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 × %2 trials</source>
        <translation>%1 × %2 Durchgänge</translation>
    </message>
    <message>
        <source>weighted up-down (%1 %), %2</source>
        <translation>gewichtetes Up-down-Verfahren (%1 %), %2</translation>
    </message>
    <message>
        <source>%1-down/1-up, %2</source>
        <translation>%1-down/1-up, %2</translation>
    </message>
    <message>
        <source>%1 % of observers with slope β = %2</source>
        <translation>%1 % der Beobachter mit der Steigung β = %2</translation>
    </message>
    <message>
        <source>In simulations of this procedure (%1), the 95 % CI of the threshold contained the true threshold for: %2.</source>
        <translation>In Simulationen dieses Verfahrens (%1) enthielt das 95-%-KI der Schwelle die wahre Schwelle bei: %2.</translation>
    </message>
    <message>
        <source>The coverage of the 95 % CIs was not simulated for the procedure of this study; it was %1 to %2 % for simulated procedures of 60 and 80 trials.</source>
        <translation>Wie oft die 95-%-KIs den wahren Wert enthalten, wurde für das Verfahren dieser Studie nicht simuliert; bei simulierten Verfahren mit 60 und 80 Durchgängen waren es %1 bis %2 %.</translation>
    </message>
    <message>
        <source>With an adaptive procedure, the slope was limited to %1 to %2.</source>
        <translation>Bei einem adaptiven Verfahren war die Steigung auf %1 bis %2 begrenzt.</translation>
    </message>
    <message>
        <source>Does the position of the surfaces matter?</source>
        <translation>Spielt die Position der Oberflächen eine Rolle?</translation>
    </message>
    <message>
        <source>Wilcoxon signed-rank test of each participant&apos;s proportions of choices of the comparison as surface A and as surface B.</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test der Anteile, mit denen jede Versuchsperson den Vergleichsreiz als Oberfläche A und als Oberfläche B wählte.</translation>
    </message>
    <message>
        <source>the difference between the proportions of choices of the comparison, as surface A minus as surface B, was %1</source>
        <translation>die Differenz der Anteile der Wahlen des Vergleichsreizes, als Oberfläche A minus als Oberfläche B, betrug %1</translation>
    </message>
    <message>
        <source>Proportions of choices of the comparison as surface A and as surface B, and their difference (A − B). In a sequence A is presented first.</source>
        <translation>Anteile der Wahlen des Vergleichsreizes als Oberfläche A und als Oberfläche B und ihre Differenz (A − B). In einer Folge wird A zuerst dargeboten.</translation>
    </message>
    <message>
        <source>Catch trials</source>
        <translation>Kontrolldurchgänge (catch trials)</translation>
    </message>
    <message>
        <source>Trials with an easy level at random places among the others. Errors and missed deadlines indicate lapses of attention. No threshold is estimated from these trials.</source>
        <translation>Durchgänge mit einer leichten Stufe an zufälligen Stellen zwischen den anderen. Fehler und versäumte Fristen weisen auf Aufmerksamkeitslücken hin. Aus diesen Durchgängen wird keine Schwelle geschätzt.</translation>
    </message>
    <message>
        <source>For each participant and condition, a cumulative normal function of the parameter was fitted by maximum likelihood, with lapse rates of 2 % in both directions; the JND is half the distance between the values at 25 % and 75 %. CIs of geometric means are t-based on the logarithmic scale.</source>
        <translation>Für jede Versuchsperson und Bedingung wurde eine kumulative Normalverteilung über dem Parameter nach der Maximum-Likelihood-Methode angepasst, mit Fehlerraten (lapse rates) von 2 % in beiden Richtungen; die Unterschiedsschwelle ist der halbe Abstand zwischen den Werten bei 25 % und 75 %. Die KIs der geometrischen Mittel beruhen auf der t-Verteilung auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>For each participant and condition, a Weibull function of the difference from the standard was fitted by maximum likelihood, with a guess rate of 1/2 and a lapse rate between 0 and 6 %; the threshold is the difference at 75 % correct responses. CIs of geometric means are t-based on the logarithmic scale.</source>
        <translation>Für jede Versuchsperson und Bedingung wurde eine Weibull-Funktion der Differenz zum Standardreiz nach der Maximum-Likelihood-Methode angepasst, mit einer Ratewahrscheinlichkeit von 1/2 und einer Fehlerrate (lapse rate) zwischen 0 und 6 %; die Schwelle ist die Differenz bei 75 % richtigen Antworten. Die KIs der geometrischen Mittel beruhen auf der t-Verteilung auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Geometric mean of the detection thresholds: %1.</source>
        <translation>Geometrisches Mittel der Wahrnehmungsschwellen: %1.</translation>
    </message>
    <message>
        <source>Geometric mean of the just-noticeable differences: %1.</source>
        <translation>Geometrisches Mittel der Unterschiedsschwellen: %1.</translation>
    </message>
    <message>
        <source>Not tested: %1. Geometric mean thresholds: %2.</source>
        <translation>Nicht getestet: %1. Geometrische Mittel der Schwellen: %2.</translation>
    </message>
    <message>
        <source>Performance: a Weibull function of the difference from the standard, fitted by maximum likelihood with a guess rate of 1/2 and a lapse rate between 0 and 6 %. JND: the difference at 75 % correct responses; JND at d′ = 1: at 76 %.</source>
        <translation>Leistungsurteil: Weibull-Funktion der Differenz zum Standardreiz, angepasst nach der Maximum-Likelihood-Methode, mit einer Ratewahrscheinlichkeit von 1/2 und einer Fehlerrate (lapse rate) zwischen 0 und 6 %. JND: Differenz bei 75 % richtigen Antworten; JND bei d′ = 1: bei 76 %.</translation>
    </message>
    <message>
        <source>95 % CI: delta method, truncated at 0.</source>
        <translation>95-%-KI: Delta-Methode, bei 0 abgeschnitten.</translation>
    </message>
    <message>
        <source>Comparison: a cumulative normal function of the parameter, fitted by maximum likelihood with lapse rates of 2 % in both directions. PSE: the value at which both responses are equally frequent; JND: half the distance between the values at 25 % and 75 %, without lapses.</source>
        <translation>Vergleichsurteil: kumulative Normalverteilung über dem Parameter, angepasst nach der Maximum-Likelihood-Methode, mit Fehlerraten (lapse rates) von 2 % in beiden Richtungen. PSE: Wert, bei dem beide Antworten gleich häufig sind; JND: halber Abstand zwischen den Werten bei 25 % und 75 %, ohne Fehlerraten.</translation>
    </message>
    <message>
        <source>95 % CI: delta method, for the JND on the logarithmic scale.</source>
        <translation>95-%-KI: Delta-Methode, für die JND auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>With an adaptive procedure, the slope of a Weibull function is limited to %1 to %2.</source>
        <translation>Bei einem adaptiven Verfahren ist die Steigung einer Weibull-Funktion auf %1 bis %2 begrenzt.</translation>
    </message>
    <message>
        <source>With an adaptive procedure, the 95 % CI is a likelihood-ratio interval whose critical value is found by running the procedure again with simulated observers (%1 repetitions; those without a threshold are counted in the table).</source>
        <translation>Bei einem adaptiven Verfahren ist das 95-%-KI ein Likelihood-Quotienten-Intervall, dessen kritischer Wert durch Wiederholung des Verfahrens mit simulierten Beobachtern bestimmt wird (%1 Wiederholungen; die ohne Schwelle sind in der Tabelle gezählt).</translation>
    </message>
    <message>
        <source>Reasons for missing numbers: %1.</source>
        <translation>Gründe für fehlende Zahlen: %1.</translation>
    </message>
    <message>
        <source>The CIs of geometric means are computed on the logarithmic scale and contain no negative numbers; the CIs of arithmetic means can contain them if the participants differ greatly.</source>
        <translation>Die KIs der geometrischen Mittel sind auf der logarithmischen Skala berechnet und enthalten keine negativen Zahlen; die KIs der arithmetischen Mittel können welche enthalten, wenn sich die Versuchspersonen stark unterscheiden.</translation>
    </message>
    <message>
        <source>%1 of the %2 pairs differ significantly (largest of these p values, Holm-corrected: %3); the table of tests contains them.</source>
        <translation>%1 der %2 Paare unterscheiden sich signifikant (größter dieser p-Werte, nach Holm korrigiert: %3); die Tabelle der Tests enthält sie.</translation>
    </message>
    <message>
        <source>%1 Not significantly different: %2.</source>
        <translation>%1 Nicht signifikant verschieden: %2.</translation>
    </message>
    <message>
        <source>No pair could differ significantly in these data: %1.</source>
        <translation>In diesen Daten konnte sich kein Paar signifikant unterscheiden: %1.</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
    <message>
        <source>Signed-rank tests leave out participants with a difference of zero, so that n differs between the tests.</source>
        <translation>Vorzeichen-Rang-Tests lassen Versuchspersonen mit einer Differenz von null aus, sodass n zwischen den Tests verschieden ist.</translation>
    </message>
    <message>
        <source>Signed-rank tests leave out participants with a difference of zero, whom n does not count: %1.</source>
        <translation>Vorzeichen-Rang-Tests lassen Versuchspersonen mit einer Differenz von null aus, die n nicht mitzählt: %1.</translation>
    </message>
    <message>
        <source>%1; the smallest attainable p is %2, so that no result could be significant with one participant whose difference is not zero; at least %3 such participants are required</source>
        <translation>%1; das kleinste erreichbare p ist %2, sodass mit einer Versuchsperson, deren Differenz nicht null ist, kein Ergebnis signifikant sein könnte; erforderlich sind mindestens %3 solche Versuchspersonen</translation>
    </message>
    <message>
        <source>%1; the smallest attainable p is %2, so that no result could be significant with %3 participants whose difference is not zero; at least %4 such participants are required</source>
        <translation>%1; das kleinste erreichbare p ist %2, sodass mit %3 Versuchspersonen, deren Differenz nicht null ist, kein Ergebnis signifikant sein könnte; erforderlich sind mindestens %4 solche Versuchspersonen</translation>
    </message>
    <message>
        <source>%1 Participants with a difference of zero, who do not affect p: %2 of %3.</source>
        <translation>%1 Versuchspersonen mit einer Differenz von null, die p nicht beeinflussen: %2 von %3.</translation>
    </message>
    <message>
        <source>Participants with a difference of zero do not affect the p of sign-flip tests, although n counts them.</source>
        <translation>Versuchspersonen mit einer Differenz von null beeinflussen das p von Vorzeichen-Permutationstests nicht, obwohl n sie mitzählt.</translation>
    </message>
    <message>
        <source>Participants with a difference of zero do not affect the p of sign-flip tests, although n counts them: %1.</source>
        <translation>Versuchspersonen mit einer Differenz von null beeinflussen das p von Vorzeichen-Permutationstests nicht, obwohl n sie mitzählt: %1.</translation>
    </message>
    <message>
        <source>%1 One of %2 participants has a difference of zero and is left out of the test.</source>
        <translation>%1 Eine von %2 Versuchspersonen hat eine Differenz von null und ist im Test nicht enthalten.</translation>
    </message>
    <message>
        <source>%1 %2 of %3 participants have a difference of zero and are left out of the test.</source>
        <translation>%1 %2 von %3 Versuchspersonen haben eine Differenz von null und sind im Test nicht enthalten.</translation>
    </message>
    <message>
        <source>%1 of the expected counts are below 5, and the smallest is %2</source>
        <translation>%1 der erwarteten Häufigkeiten sind kleiner als 5, und die kleinste ist %2</translation>
    </message>
    <message>
        <source>Goodness of fit has no p: %1.</source>
        <translation>Die Anpassungsgüte hat keinen p-Wert: %1.</translation>
    </message>
    <message>
        <source>This cannot be tested with so few comparisons: %1, so that the distribution of G² is unknown. Collect more comparisons of each pair.</source>
        <translation>Dies lässt sich mit so wenigen Vergleichen nicht testen: %1, sodass die Verteilung von G² unbekannt ist. Erheben Sie mehr Vergleiche jedes Paars.</translation>
    </message>
    <message>
        <source>A likelihood-ratio test requires that no expected count is below 1 and that at most 20 % of them are below 5 (Cochran 1954).</source>
        <translation>Ein Likelihood-Quotienten-Test setzt voraus, dass keine erwartete Häufigkeit kleiner als 1 ist und höchstens 20 % von ihnen kleiner als 5 sind (Cochran 1954).</translation>
    </message>
    <message>
        <source>Likelihood-ratio test against a separate probability of each outcome for every pair, and for either order where the model has an order effect; all responses are treated as independent. Exploratory. %1.</source>
        <translation>Likelihood-Quotienten-Test gegen eine eigene Wahrscheinlichkeit jedes Ergebnisses für jedes Paar, und für jede der beiden Reihenfolgen, wenn das Modell einen Reihenfolgeeffekt hat; alle Antworten werden als unabhängig behandelt. Explorativ. %1.</translation>
    </message>
    <message>
        <source>Means over the participants who compared every pair equally often, with t-based 95 % CIs, truncated at 0 and 1 (on the logit scale where the proportions of all participants are equal); a tie counts half. Mean rank: 1 for the item that a participant chose least often.</source>
        <translation>Mittelwerte über die Versuchspersonen, die jedes Paar gleich häufig verglichen haben, mit t-basierten 95-%-KI, auf den Bereich von 0 bis 1 begrenzt (auf der Logit-Skala, wenn die Anteile aller Versuchspersonen gleich sind); ein Gleichstand zählt halb. Mittlerer Rang: 1 für das Item, das eine Versuchsperson am seltensten gewählt hat.</translation>
    </message>
    <message>
        <source>%1 Participants with an unfinished track: %2 of %3.</source>
        <translation>%1 Versuchspersonen mit einer unvollständigen Folge (Track): %2 von %3.</translation>
    </message>
    <message>
        <source>%1 Estimates from unfinished tracks that are included in the mean, because the presented trials were sufficient: %2 of %3.</source>
        <translation>%1 Schätzungen aus unvollständigen Folgen (Tracks), die im Mittelwert enthalten sind, weil die dargebotenen Durchgänge ausreichten: %2 von %3.</translation>
    </message>
    <message>
        <source>%1 Not tested, %2: %3.</source>
        <translation>%1 Nicht getestet, %2: %3.</translation>
    </message>
    <message>
        <source>Unfinished tracks: tracks that were begun and not finished, because the session ended before the procedure stopped. The threshold is estimated from the presented trials and is included in the means and tests if it lies within the presented levels, the condition for every threshold.</source>
        <translation>Unvollständige Folgen (Tracks): begonnene Folgen, die nicht abgeschlossen wurden, weil die Sitzung endete, bevor das Verfahren abgeschlossen war. Die Schwelle ist aus den dargebotenen Durchgängen geschätzt und in Mittelwerten und Tests enthalten, wenn sie innerhalb der dargebotenen Stufen liegt; diese Bedingung gilt für jede Schwelle.</translation>
    </message>
    <message>
        <source>Intraclass correlations with the items as targets and the participants as raters: ICC2 measures agreement, ICC3 consistency; k: of the mean of all participants.</source>
        <translation>Intraklassenkorrelationen mit den Items als Urteilsobjekten und den Versuchspersonen als Beurteilern: ICC2 misst Übereinstimmung, ICC3 Konsistenz; k: des Mittelwerts aller Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 Loadings are not reported: they require at least five items per component, and %2 items were rated on every scale.</source>
        <translation>%1 Ladungen werden nicht berichtet: Sie erfordern mindestens fünf Items je Komponente, und auf allen Skalen beurteilt wurden %2.</translation>
    </message>
    <message>
        <source>%1 Only the first components are reported, one for every five of the %2 items.</source>
        <translation>%1 Nur die ersten Komponenten werden berichtet, eine je fünf der %2 Items.</translation>
    </message>
    <message>
        <source>%1 (reverse-keyed: %2)</source>
        <translation>%1 (umgepolt: %2)</translation>
    </message>
    <message>
        <source>Not defined for the scales %1.</source>
        <translation>Für die Skalen %1 nicht definiert.</translation>
    </message>
    <message>
        <source>Cronbach’s α = %1, 95 % CI [%2, %3], N = %4 participants, of the scales %5.</source>
        <translation>Cronbachs α = %1, 95-%-KI [%2; %3], N = %4 Versuchspersonen, der Skalen %5.</translation>
    </message>
    <message>
        <source>Cronbach’s α = %1, N = %2 participants, of the scales %3.</source>
        <translation>Cronbachs α = %1, N = %2 Versuchspersonen, der Skalen %3.</translation>
    </message>
    <message>
        <source>How consistent are the scales of the construct “%1”?</source>
        <translation>Wie konsistent sind die Skalen des Konstrukts „%1“?</translation>
    </message>
    <message>
        <source>Internal consistency of the declared constructs</source>
        <translation>Interne Konsistenz der angegebenen Konstrukte</translation>
    </message>
    <message>
        <source>Cronbach’s α of the scales of each construct. cells: combinations of a participant and an item that were rated on all of its scales.</source>
        <translation>Cronbachs α der Skalen jedes Konstrukts. Zellen: Kombinationen aus Versuchsperson und Item, die auf allen seinen Skalen beurteilt wurden.</translation>
    </message>
    <message>
        <source>How reliable are the ratings on the scale “%1” over repetitions?</source>
        <translation>Wie reliabel sind die Urteile auf der Skala „%1“ über Wiederholungen?</translation>
    </message>
    <message>
        <source>Each participant&apos;s own intraclass correlation (consistency) of the ratings, with the items as targets and the repetitions as raters; mean over the participants with a t-based CI. It is also low where a participant rates the items alike.</source>
        <translation>Intraklassenkorrelation (Konsistenz) der Urteile jeder Versuchsperson, mit den Items als Urteilsobjekten und den Wiederholungen als Beurteilern; Mittelwert über die Versuchspersonen mit t-basiertem KI. Sie ist auch dann niedrig, wenn eine Versuchsperson die Items ähnlich beurteilt.</translation>
    </message>
    <message>
        <source>Choices and exploration: logistic mixed model</source>
        <translation>Wahlen und Exploration: logistisches gemischtes Modell</translation>
    </message>
    <message>
        <source>Logistic mixed model of the choices of the comparison, with the conditions and random intercepts of participants. Differences are those of the comparison from the standard: of the level, and of the mean normal force and the mean speed during contact. Odds ratios per SD over the trials, and of the position, with Wald’s 95 % CIs. Exploratory: participants chose force and speed themselves, and the CIs are too narrow where they differ in these effects.</source>
        <translation>Logistisches gemischtes Modell der Wahlen des Vergleichsreizes, mit den Bedingungen und zufälligen Achsenabschnitten der Versuchspersonen. Differenzen sind die des Vergleichsreizes vom Standard: der Stufe sowie der mittleren Normalkraft und der mittleren Geschwindigkeit während des Kontakts. Odds-Ratios je SD über die Durchgänge und für die Position, mit Wald-95-%-KI. Explorativ: Die Versuchspersonen wählten Kraft und Geschwindigkeit selbst, und die KI sind zu schmal, wenn sie sich in diesen Effekten unterscheiden.</translation>
    </message>
    <message>
        <source>Responses to trials without the surfaces of the design or without a level, which are left out: %1.</source>
        <translation>Nicht berücksichtigte Antworten auf Durchgänge ohne die Oberflächen des Designs oder ohne Stufe: %1.</translation>
    </message>
    <message>
        <source>For each participant and condition, responses “yes” were modelled by signal detection, with d′ a power function of the difference from the standard, by maximum likelihood; the threshold is the difference with d′ = 1 [Macmillan 2005]. CIs of geometric means are t-based on the logarithmic scale.</source>
        <translation>Für jede Versuchsperson und Bedingung wurden die Antworten „ja“ nach der Signalentdeckungstheorie mit der Maximum-Likelihood-Methode modelliert, mit d′ als Potenzfunktion des Unterschieds zum Standard; die Schwelle ist der Unterschied mit d′ = 1 [Macmillan 2005]. KI geometrischer Mittel sind t-basiert auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>For each participant and condition, responses “different” were modelled by signal detection with the differencing rule, with d′ a power function of the difference from the standard, by maximum likelihood; the threshold is the difference with d′ = 1 [Macmillan 2005]. CIs of geometric means are t-based on the logarithmic scale.</source>
        <translation>Für jede Versuchsperson und Bedingung wurden die Antworten „verschieden“ nach der Signalentdeckungstheorie mit der Differenzregel mit der Maximum-Likelihood-Methode modelliert, mit d′ als Potenzfunktion des Unterschieds zum Standard; die Schwelle ist der Unterschied mit d′ = 1 [Macmillan 2005]. KI geometrischer Mittel sind t-basiert auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Two alternatives: hits are responses “the first” with the comparison as surface A, false alarms the same responses with the comparison as surface B; d′ = (z(H) − z(F))/√2 [Macmillan 2005]. A positive criterion is a bias towards surface B.</source>
        <translation>Zwei Alternativen: Treffer sind Antworten „die erste“ mit dem Vergleich als Oberfläche A, falsche Alarme dieselben Antworten mit dem Vergleich als Oberfläche B; d′ = (z(H) − z(F))/√2 [Macmillan 2005]. Ein positives Kriterium ist eine Neigung zu Oberfläche B.</translation>
    </message>
    <message>
        <source>Yes/no: hits are responses “yes” to the comparison, false alarms those to the standard, over all levels of the condition together; d′ = z(H) − z(F) [Macmillan 2005]. A positive criterion is a reluctance to respond “yes”.</source>
        <translation>Ja/Nein: Treffer sind Antworten „ja“ auf den Vergleich, falsche Alarme solche auf den Standard, bei allen Stufen der Bedingung zusammen; d′ = z(H) − z(F) [Macmillan 2005]. Ein positives Kriterium ist eine Zurückhaltung, „ja“ zu antworten.</translation>
    </message>
    <message>
        <source>Same–different: hits are responses “different” to different surfaces, false alarms those to equal surfaces, over all levels of the condition together. d′ by the differencing rule, and d′ by the rule of independent observations [Macmillan 2005]. By the differencing rule the response is “different” where two impressions differ by more than the criterion k, which is estimated from the false alarms, in standard deviations of an impression.</source>
        <translation>Gleich–verschieden: Treffer sind Antworten „verschieden“ auf verschiedene Oberflächen, falsche Alarme solche auf gleiche Oberflächen, bei allen Stufen der Bedingung zusammen. d′ nach der Differenzregel und d′ nach der Regel unabhängiger Beobachtungen [Macmillan 2005]. Nach der Differenzregel ist die Antwort „verschieden“, wenn sich zwei Eindrücke um mehr als das Kriterium k unterscheiden, das aus den falschen Alarmen geschätzt ist, in Standardabweichungen eines Eindrucks.</translation>
    </message>
    <message>
        <source>d′ is computed with the log-linear correction of the proportions [Hautus 1995], its 95 % CI by the delta method.</source>
        <translation>d′ ist mit der log-linearen Korrektur der Anteile berechnet [Hautus 1995], sein 95-%-KI mit der Delta-Methode.</translation>
    </message>
    <message>
        <source>Rows in which the hit rate and the false-alarm rate are both 0 or both 1, with different numbers of trials with and without a signal: %1. Their d′ depends on these numbers alone, because the corrected rates, (responses + ½)/(trials + 1), are equal only for equal numbers. With more trials without a signal, it is above 0 if both rates are 0, and below 0 (same–different: 0) if both are 1.</source>
        <translation>Zeilen, in denen die Trefferrate und die Rate falscher Alarme beide 0 oder beide 1 sind, mit verschiedenen Anzahlen von Durchgängen mit und ohne Signal: %1. Ihr d′ hängt allein von diesen Anzahlen ab, weil die korrigierten Raten, (Antworten + ½)/(Durchgänge + 1), nur bei gleichen Anzahlen gleich sind. Bei mehr Durchgängen ohne Signal ist es über 0, wenn beide Raten 0 sind, und unter 0 (Gleich–verschieden: 0), wenn beide 1 sind.</translation>
    </message>
    <message>
        <source>How large is the sensitivity (d′) at each level?</source>
        <translation>Wie groß ist die Sensitivität (d′) bei jeder Stufe?</translation>
    </message>
    <message>
        <source>Mean d′ by the %1 of the comparison: %2.</source>
        <translation>Mittleres d′ nach %1 des Vergleichs: %2.</translation>
    </message>
    <message>
        <source>Mean over the participants of d′ with the log-linear correction; CIs by expanded percentiles of a bootstrap over participants, with six participants or more.</source>
        <translation>Mittelwert über die Versuchspersonen von d′ mit log-linearer Korrektur; KI durch erweiterte Perzentile eines Bootstraps über die Versuchspersonen, ab sechs Versuchspersonen.</translation>
    </message>
    <message>
        <source>Sensitivity by level</source>
        <translation>Sensitivität nach Stufe</translation>
    </message>
    <message>
        <source>Responses by pair of surfaces</source>
        <translation>Antworten nach Oberflächenpaar</translation>
    </message>
    <message>
        <source>Responses “different” to every pair of surfaces, in the order of presentation (side by side: A, B), over all levels together.</source>
        <translation>Antworten „verschieden“ auf jedes Oberflächenpaar, in der Reihenfolge der Darbietung (nebeneinander: A, B), bei allen Stufen zusammen.</translation>
    </message>
    <message>
        <source>Yes/no: responses are modelled as P(yes) = Φ(d′ − k) with d′ = (x/α)^β, x the difference from the standard and 2 % lapses in both directions, by maximum likelihood. JND at d′ = 1: α [Macmillan 2005]; 95 % CI: Wald, on the logarithmic scale.</source>
        <translation>Ja/Nein: Die Antworten sind mit der Maximum-Likelihood-Methode als P(ja) = Φ(d′ − k) modelliert, mit d′ = (x/α)^β, x dem Unterschied zum Standard und 2 % Lapses in beiden Richtungen. JND bei d′ = 1: α [Macmillan 2005]; 95-%-KI: Wald, auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Same–different: responses are modelled by the differencing rule, P(different) = Φ((d′ − k)/√2) + Φ((−d′ − k)/√2) with d′ = (x/α)^β, x the difference from the standard and 2 % lapses in both directions, by maximum likelihood. JND at d′ = 1: α [Macmillan 2005]; 95 % CI: Wald, on the logarithmic scale.</source>
        <translation>Gleich–verschieden: Die Antworten sind mit der Maximum-Likelihood-Methode nach der Differenzregel modelliert, P(verschieden) = Φ((d′ − k)/√2) + Φ((−d′ − k)/√2), mit d′ = (x/α)^β, x dem Unterschied zum Standard und 2 % Lapses in beiden Richtungen. JND bei d′ = 1: α [Macmillan 2005]; 95-%-KI: Wald, auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Hits are responses “yes”; those at a difference of 0 are false alarms.</source>
        <translation>Treffer sind Antworten „ja“; die bei einem Unterschied von 0 sind falsche Alarme.</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>Mean dissimilarities of the pairs</source>
        <translation>Mittlere Unähnlichkeiten der Paare</translation>
    </message>
    <message>
        <source>Configuration of the items</source>
        <translation>Konfiguration der Items</translation>
    </message>
    <message>
        <source>Stress by the number of dimensions</source>
        <translation>Stress nach der Zahl der Dimensionen</translation>
    </message>
    <message>
        <source>Kruskal’s stress-1 of non-metric and of metric (ratio) scaling; 0 is a perfect fit. Prediction error: root mean square error of the prediction of each participant’s ratings from those of the others (cross-validation), in the unit of the scale; next to it, its square minus that of the best number of dimensions, with the standard error over participants.</source>
        <translation>Kruskals Stress-1 der nichtmetrischen und der metrischen (Verhältnis-)Skalierung; 0 ist eine vollkommene Anpassung. Vorhersagefehler: quadratisches Mittel der Fehler bei der Vorhersage der Urteile jeder Versuchsperson aus denen der anderen (Kreuzvalidierung), in der Einheit der Skala; daneben sein Quadrat abzüglich desjenigen der besten Zahl der Dimensionen, mit dem Standardfehler über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>Participants: reliability, agreement, and weights of the dimensions</source>
        <translation>Versuchspersonen: Reliabilität, Übereinstimmung und Gewichte der Dimensionen</translation>
    </message>
    <message>
        <source>Correlations of the first and the last rating of a pair, of the ratings in its two orders, and of the participant’s mean ratings with those of the others. Fit: the proportion of the participant’s scalar products that the INDSCAL model explains; the weights are those of its dimensions, which differ from the axes of the configuration.</source>
        <translation>Korrelationen des ersten und des letzten Urteils über ein Paar, der Urteile in seinen beiden Reihenfolgen und der mittleren Urteile der Versuchsperson mit denen der anderen. Anpassung: der Anteil der Skalarprodukte der Versuchsperson, den das INDSCAL-Modell erklärt; die Gewichte gelten für dessen Dimensionen, die sich von den Achsen der Konfiguration unterscheiden.</translation>
    </message>
    <message>
        <source>Dendrogram of the items</source>
        <translation>Dendrogramm der Items</translation>
    </message>
    <message>
        <source>Average linkage of the mean dissimilarities. Each row joins the cluster of the first item with that of the second.</source>
        <translation>Average Linkage der mittleren Unähnlichkeiten. In jeder Zeile wird der Cluster des ersten Items mit dem des zweiten zusammengeführt.</translation>
    </message>
    <message>
        <source>Measured properties of the items in the configuration</source>
        <translation>Gemessene Eigenschaften der Items in der Konfiguration</translation>
    </message>
    <message>
        <source>R² of the regression of the property on the positions, and the direction in which it increases (of length 1). Forces and speeds are means over the participants’ contacts with the item: they depend on how it was explored. Texture force: the RMS along the participants’ paths.</source>
        <translation>R² der Regression der Eigenschaft auf die Positionen und die Richtung, in der sie zunimmt (mit der Länge 1). Kräfte und Geschwindigkeiten sind Mittelwerte über die Kontakte der Versuchspersonen mit dem Item: Sie hängen davon ab, wie es erkundet wurde. Texturkraft: der Effektivwert entlang der Wege der Versuchspersonen.</translation>
    </message>
    <message>
        <source>The configuration is poorly determined: %1 dimensions require at least %2 items, and the number of items is %3.</source>
        <translation>Die Konfiguration ist schlecht bestimmt: %1 Dimensionen erfordern mindestens %2 Items, und die Zahl der Items ist %3.</translation>
    </message>
    <message>
        <source>Cross-validation chooses one dimension; the configuration is shown in two, and the second may be due to chance.</source>
        <translation>Die Kreuzvalidierung wählt eine Dimension; die Konfiguration wird in zweien gezeigt, und die zweite kann auf Zufall beruhen.</translation>
    </message>
    <message>
        <source>Do the ratings have a structure, and in how many dimensions?</source>
        <translation>Haben die Urteile eine Struktur, und in wie vielen Dimensionen?</translation>
    </message>
    <message>
        <source>Not tested: with %1 surfaces, a configuration in %2 dimensions fits many permuted ratings perfectly, so that no ratings can fit significantly better; see the mean dissimilarities of the pairs.</source>
        <translation>Nicht getestet: Bei %1 Oberflächen passt eine Konfiguration in %2 Dimensionen vollkommen zu vielen permutierten Urteilen, sodass keine Urteile signifikant besser passen können; siehe die mittleren Unähnlichkeiten der Paare.</translation>
    </message>
    <message>
        <source>Yes: the configuration in %1 dimensions has a stress-1 of %2, lower than that of permuted ratings (mean %3). Permutation test: %4.</source>
        <translation>Ja: Die Konfiguration in %1 Dimensionen hat einen Stress-1 von %2, kleiner als der permutierter Urteile (Mittelwert %3). Permutationstest: %4.</translation>
    </message>
    <message>
        <source>%1 All properties together, as a configuration of their standardised values: Procrustes r² = %2, permutation test (PROTEST) %3.</source>
        <translation>%1 Alle Eigenschaften zusammen, als Konfiguration ihrer standardisierten Werte: Prokrustes-r² = %2, Permutationstest (PROTEST) %3.</translation>
    </message>
    <message>
        <source>Relative amplitudes of equal roughness</source>
        <translation>Relative Amplituden gleicher Rauheit</translation>
    </message>
    <message>
        <source>Relative amplitudes of equal roughness: means</source>
        <translation>Relative Amplituden gleicher Rauheit: Mittelwerte</translation>
    </message>
    <message>
        <source>Factor by which the amplitude was multiplied, so that the participant judged the stimulus as rough as the reference. below_range and above_range: rougher, or less rough, at every amplitude, and presented at the end of the range. unmatched: too few reversals, and presented unchanged.</source>
        <translation>Faktor, mit dem die Amplitude multipliziert wurde, damit die Versuchsperson den Reiz als so rau wie die Referenz beurteilte. below_range und above_range: bei jeder Amplitude rauer oder weniger rau, mit dem Ende des Bereichs dargeboten. unmatched: zu wenige Umkehrpunkte, unverändert dargeboten.</translation>
    </message>
    <message>
        <source>The surfaces were presented at amplitudes of equal roughness; all %1 matches succeeded.</source>
        <translation>Die Oberflächen wurden mit Amplituden gleicher Rauheit dargeboten; alle %1 Angleichungen gelangen.</translation>
    </message>
    <message>
        <source>The surfaces were presented at amplitudes of equal roughness; %1 of %2 matches did not succeed, so that these stimuli were presented at the end of the range or unchanged (the table lists them).</source>
        <translation>Die Oberflächen wurden mit Amplituden gleicher Rauheit dargeboten; %1 von %2 Angleichungen gelangen nicht, sodass diese Reize mit dem Ende des Bereichs oder unverändert dargeboten wurden (die Tabelle führt sie auf).</translation>
    </message>
    <message>
        <source>%1 of %2 responses are “cannot tell”. Each counts as the mean of a guess in psychometric functions and in the order effect. The logistic mixed model of choices does not contain them, and d′ is not computed, because its counts need a choice in every trial.</source>
        <translation>%1 von %2 Antworten sind „kann es nicht sagen“. Jede zählt in psychometrischen Funktionen und im Reihenfolgeeffekt als Mittel eines geratenen Ergebnisses. Das logistische gemischte Modell der Wahlen enthält sie nicht, und d′ wird nicht berechnet, weil seine Zählungen in jedem Durchgang eine Wahl brauchen.</translation>
    </message>
    <message>
        <source>Each response “cannot tell” counts as the mean of a guess: 1/m of a hit, with m alternatives [Kaernbach 2001]. Split counts are not binomial, so that the goodness of fit of these functions is not tested.</source>
        <translation>Jede Antwort „kann es nicht sagen“ zählt als Mittel eines geratenen Ergebnisses: bei m Alternativen als 1/m eines Treffers [Kaernbach 2001]. Aufgeteilte Anzahlen sind nicht binomialverteilt, sodass die Anpassungsgüte dieser Funktionen nicht getestet wird.</translation>
    </message>
    <message>
        <source>Responses “cannot tell”</source>
        <translation>Antworten „kann es nicht sagen“</translation>
    </message>
    <message>
        <source>Proportion of the responses “cannot tell” among all responses, with Wilson’s 95 % CI. In psychometric functions, in proportions of hits and in the order effect such a response counts as the mean of a guess, that is, as 1/m of a choice of each of the m alternatives [Kaernbach 2001].</source>
        <translation>Anteil der Antworten „kann es nicht sagen“ an allen Antworten, mit dem 95-%-KI nach Wilson. In psychometrischen Funktionen, in Trefferanteilen und im Reihenfolgeeffekt zählt eine solche Antwort als Mittel eines geratenen Ergebnisses, also bei m Alternativen als 1/m einer Wahl jeder Alternative [Kaernbach 2001].</translation>
    </message>
    <message>
        <source>Three alternatives: d′ of an unbiased choice of the greatest of three impressions [Hacker 1979].</source>
        <translation>Drei Alternativen: d′ einer Wahl des größten von drei Eindrücken ohne Antwortneigung [Hacker 1979].</translation>
    </message>
    <message>
        <source>Oddity: d′ by the differencing rule [Frijters 1979], and d′ by the rule of independent observations [Versfeld 1996]; 0 for proportions up to 1/3.</source>
        <translation>Oddity: d′ nach der Differenzregel [Frijters 1979] und d′ nach der Regel unabhängiger Beobachtungen [Versfeld 1996]; 0 bei Anteilen bis 1/3.</translation>
    </message>
    <message>
        <source>Sensitivity by level, from the proportion correct</source>
        <translation>Sensitivität nach Stufe, aus dem Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>For each participant and condition, a Weibull function of the difference from the standard was fitted by maximum likelihood, with a guess rate of 1/3 and a lapse rate between 0 and 6 %; the threshold is the difference at 66.7 % correct responses. CIs of geometric means are t-based on the logarithmic scale.</source>
        <translation>Für jede Versuchsperson und Bedingung wurde eine Weibull-Funktion der Differenz zum Standardreiz nach der Maximum-Likelihood-Methode angepasst, mit einer Ratewahrscheinlichkeit von 1/3 und einer Fehlerrate (lapse rate) zwischen 0 und 6 %; die Schwelle ist die Differenz bei 66,7 % richtigen Antworten. Die KIs der geometrischen Mittel beruhen auf der t-Verteilung auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Friedman test of each participant&apos;s proportions of choices of the surfaces A, B and C, averaged over the positions of the correct one.</source>
        <translation>Friedman-Test der Anteile, mit denen jede Versuchsperson die Oberflächen A, B und C wählte, gemittelt über die Positionen der richtigen.</translation>
    </message>
    <message>
        <source>This cannot be estimated: no participant felt the surface that is to be chosen in every position.</source>
        <translation>Das kann nicht geschätzt werden: Keine Versuchsperson fühlte die zu wählende Oberfläche an jeder Position.</translation>
    </message>
    <message>
        <source>mean proportions of choices: %1</source>
        <translation>mittlere Anteile der Wahlen: %1</translation>
    </message>
    <message>
        <source>Three alternatives: a Weibull function of the difference from the standard, fitted by maximum likelihood with a guess rate of 1/3 and a lapse rate between 0 and 6 %. JND: the difference at 66.7 % correct responses; JND at d′ = 1: at 63.4 % [Hacker 1979].</source>
        <translation>Drei Alternativen: Weibull-Funktion der Differenz zum Standardreiz, angepasst nach der Maximum-Likelihood-Methode, mit einer Ratewahrscheinlichkeit von 1/3 und einer Fehlerrate (lapse rate) zwischen 0 und 6 %. JND: Differenz bei 66,7 % richtigen Antworten; JND bei d′ = 1: bei 63,4 % [Hacker 1979].</translation>
    </message>
    <message>
        <source>Oddity: a Weibull function of the difference from the standard, fitted by maximum likelihood with a guess rate of 1/3 and a lapse rate between 0 and 6 %. JND: the difference at 66.7 % correct responses; JND at d′ = 1: at 41.8 %, by the differencing rule [Frijters 1979].</source>
        <translation>Oddity: Weibull-Funktion der Differenz zum Standardreiz, angepasst nach der Maximum-Likelihood-Methode, mit einer Ratewahrscheinlichkeit von 1/3 und einer Fehlerrate (lapse rate) zwischen 0 und 6 %. JND: Differenz bei 66,7 % richtigen Antworten; JND bei d′ = 1: bei 41,8 %, nach der Differenzregel [Frijters 1979].</translation>
    </message>
    <message>
        <source>Posterior JND: mean of the posterior distribution of the JND on the logarithmic scale, with the prior of the procedure, and its 95 % credible interval (CrI).</source>
        <translation>A-posteriori-JND: Mittel der A-posteriori-Verteilung der JND auf der logarithmischen Skala, mit der A-priori-Verteilung des Verfahrens, und ihr 95-%-Glaubwürdigkeitsintervall.</translation>
    </message>
    <message>
        <source>Choices by position</source>
        <translation>Wahlen nach Position</translation>
    </message>
    <message>
        <source>Proportions of choices of each of the three surfaces, averaged over the positions of the correct one; 1/3 without a preference. In a sequence A is presented first.</source>
        <translation>Anteile der Wahlen jeder der drei Oberflächen, gemittelt über die Positionen der richtigen; 1/3 ohne Bevorzugung. In einer Folge wird A zuerst dargeboten.</translation>
    </message>
    <message>
        <source>%1, d_a = %2, SD ratio %3</source>
        <translation>%1, d_a = %2, Verhältnis der SD %3</translation>
    </message>
    <message>
        <source>%1, test of equal variances χ²(1) = %2, %3</source>
        <translation>%1, Test gleicher Varianzen χ²(1) = %2, %3</translation>
    </message>
    <message>
        <source>How large is the area under the ROC of the confidence ratings?</source>
        <translation>Wie groß ist die Fläche unter der ROC der Sicherheitsurteile?</translation>
    </message>
    <message>
        <source>It could not be estimated: signal and noise trials share too few categories of response and confidence.</source>
        <translation>Sie konnte nicht geschätzt werden: Durchgänge mit und ohne Signal haben zu wenige Kategorien von Antwort und Sicherheit gemeinsam.</translation>
    </message>
    <message>
        <source>ROC of the confidence ratings</source>
        <translation>ROC der Sicherheitsurteile</translation>
    </message>
    <message>
        <source>Responses left out because they are not numbers above 0: %1.</source>
        <translation>Ausgelassene Antworten, die keine Zahlen über 0 sind: %1.</translation>
    </message>
    <message>
        <source>Free modulus: each participant&apos;s scale is removed (the mean of the logarithms of all cells is subtracted, and the grand mean added).</source>
        <translation>Freier Modulus: Die eigene Skala jeder Versuchsperson ist entfernt (der Mittelwert der Logarithmen aller Zellen wird abgezogen und der Gesamtmittelwert addiert).</translation>
    </message>
    <message>
        <source>Standard with modulus %1 (%2): each participant&apos;s estimates are divided by the geometric mean of that participant&apos;s estimates of the standard, and multiplied by the modulus.</source>
        <translation>Standardreiz mit Modulus %1 (%2): Die Schätzungen jeder Versuchsperson sind durch das geometrische Mittel ihrer Schätzungen des Standardreizes geteilt und mit dem Modulus multipliziert.</translation>
    </message>
    <message>
        <source>Standard with modulus %1 (%2): the estimates are not normalised, because the standard determines the modulus of all participants.</source>
        <translation>Standardreiz mit Modulus %1 (%2): Die Schätzungen sind nicht normiert, weil der Standardreiz den Modulus aller Versuchspersonen festlegt.</translation>
    </message>
    <message>
        <source>Geometric means of the estimates. %1 raw: not normalised. left out: number of participants without an estimate in some cell; only raw includes them.</source>
        <translation>Geometrische Mittel der Schätzungen. %1 roh: nicht normiert. weggelassen: Anzahl der Versuchspersonen, denen in einer Zelle eine Schätzung fehlt; nur „roh“ enthält sie.</translation>
    </message>
    <message>
        <source>There is no exponent, because the predictor is unknown or not above 0 for these stimuli: %1.</source>
        <translation>Es gibt keinen Exponenten, weil der Prädiktor für diese Reize unbekannt oder nicht größer als 0 ist: %1.</translation>
    </message>
    <message>
        <source>Estimates by stimulus and condition</source>
        <translation>Schätzungen nach Reiz und Bedingung</translation>
    </message>
    <message>
        <source>Exponents of the power functions</source>
        <translation>Exponenten der Potenzfunktionen</translation>
    </message>
    <message>
        <source>Slopes of log estimate on the logarithm of the predictor (%1), by least squares per participant: mean over the participants with its t-based 95 % CI, and p of the t test against 0, uncorrected. R²: fit of the line to the means of the stimuli.</source>
        <translation>Steigungen der logarithmierten Schätzung über dem Logarithmus des Prädiktors (%1), nach kleinsten Quadraten je Versuchsperson: Mittelwert über die Versuchspersonen mit seinem 95-%-KI nach t und p des t-Tests gegen 0, unkorrigiert. R²: Anpassung der Geraden an die Mittelwerte der Reize.</translation>
    </message>
    <message>
        <source>exponent %1</source>
        <translation>Exponent %1</translation>
    </message>
    <message>
        <source>How do the estimates grow with the predictor (%1)?</source>
        <translation>Wie wachsen die Schätzungen mit dem Prädiktor (%1)?</translation>
    </message>
    <message>
        <source>Power function: %1.</source>
        <translation>Potenzfunktion: %1.</translation>
    </message>
    <message>
        <source>The exponent is the slope of log estimate on the logarithm of the predictor, by least squares per participant; mean and t-based CI over the participants.</source>
        <translation>Der Exponent ist die Steigung der logarithmierten Schätzung über dem Logarithmus des Prädiktors, nach kleinsten Quadraten je Versuchsperson; Mittelwert und KI nach t über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>Do the estimates depend on the stimulus?</source>
        <translation>Hängen die Schätzungen vom Reiz ab?</translation>
    </message>
    <message>
        <source>Do the estimates depend on the condition?</source>
        <translation>Hängen die Schätzungen von der Bedingung ab?</translation>
    </message>
    <message>
        <source>Does the effect of the stimulus depend on the condition?</source>
        <translation>Hängt die Wirkung des Reizes von der Bedingung ab?</translation>
    </message>
    <message>
        <source>more than 1 error</source>
        <translation>mehr als 1 Fehler</translation>
    </message>
    <message>
        <source>more than %1 errors</source>
        <translation>mehr als %1 Fehler</translation>
    </message>
    <message>
        <source>errors in more than %1 of the catch trials</source>
        <translation>Fehler in mehr als %1 der Kontrolldurchgänge</translation>
    </message>
    <message>
        <source>%1, with the excluded participants</source>
        <translation>%1, mit den ausgeschlossenen Versuchspersonen</translation>
    </message>
    <message>
        <source>Exclusions by errors in catch trials</source>
        <translation>Ausschlüsse wegen Fehlern in Kontrolldurchgängen</translation>
    </message>
    <message>
        <source>Rule that the protocol declares: participants with %1 are excluded, all types of catch trials and all blocks together. Their stored responses are unchanged.</source>
        <translation>Im Protokoll festgelegte Regel: Versuchspersonen werden ausgeschlossen bei: %1 (alle Arten von Kontrolldurchgängen und alle Blöcke zusammen). Ihre gespeicherten Antworten bleiben unverändert.</translation>
    </message>
    <message>
        <source>The declared rule (%1) excludes all participants, so that the results are those of the excluded participants.</source>
        <translation>Die festgelegte Regel (%1) schließt alle Versuchspersonen aus, sodass die Ergebnisse die der ausgeschlossenen Versuchspersonen sind.</translation>
    </message>
    <message>
        <source>Participants whom the declared rule (%3) excludes: %1 of %2 (%4). Results are those without these participants; tables with the excluded participants follow. Tables of response times, learning, exploration and anchors contain all participants.</source>
        <translation>Versuchspersonen, die die festgelegte Regel (%3) ausschließt: %1 von %2 (%4). Die Ergebnisse sind die ohne diese Versuchspersonen; Tabellen mit den ausgeschlossenen Versuchspersonen folgen. Tabellen der Antwortzeiten, des Lernens, der Exploration und der Anker enthalten alle Versuchspersonen.</translation>
    </message>
    <message>
        <source>No signal: the standard was presented twice, and “cannot tell” is correct. Every choice is a false alarm.</source>
        <translation>Kein Signal: Der Standard wurde zweimal dargeboten, und „kann es nicht sagen“ ist richtig. Jede Wahl ist ein falscher Alarm.</translation>
    </message>
    <message>
        <source>Identical pair: the standard was presented twice, and “cannot tell” is correct. Every choice is an error.</source>
        <translation>Gleiches Paar: Der Standard wurde zweimal dargeboten, und „kann es nicht sagen“ ist richtig. Jede Wahl ist ein Fehler.</translation>
    </message>
    <message>
        <source>The estimates are not normalised by the standard (%1), because there is no estimate of it.</source>
        <translation>Die Schätzungen sind nicht auf den Standard (%1) normiert, weil es keine Schätzung von ihm gibt.</translation>
    </message>
    <message>
        <source>Standard with modulus %1 (%2): the estimates are not normalised, because there is no estimate of the standard.</source>
        <translation>Standard mit Modulus %1 (%2): Die Schätzungen sind nicht normiert, weil es keine Schätzung des Standards gibt.</translation>
    </message>
    <message>
        <source>Mean over the participants of d′ by the differencing rule, of (correct responses + 1/3)/(trials + 1), which is finite; CIs by expanded percentiles of a bootstrap over participants, with six participants or more.</source>
        <translation>Mittelwert über die Versuchspersonen von d′ nach der Differenzregel, aus (richtige Antworten + 1/3)/(Durchgänge + 1) und daher endlich; KI durch erweiterte Perzentile eines Bootstraps über die Versuchspersonen, ab sechs Versuchspersonen.</translation>
    </message>
    <message>
        <source>Mean over the participants of d′ of (correct responses + 1/3)/(trials + 1), which is finite; CIs by expanded percentiles of a bootstrap over participants, with six participants or more.</source>
        <translation>Mittelwert über die Versuchspersonen von d′ aus (richtige Antworten + 1/3)/(Durchgänge + 1) und daher endlich; KI durch erweiterte Perzentile eines Bootstraps über die Versuchspersonen, ab sechs Versuchspersonen.</translation>
    </message>
    <message>
        <source>95 % CI of d′: Wilson limits of the proportion correct. d′ is missing where every response or no response is correct. Corrected d′: that of (correct responses + 1/3)/(trials + 1), which is finite for every number of correct responses; the means over the participants are means of the corrected d′.</source>
        <translation>95-%-KI von d′: Wilson-Grenzen des Anteils richtiger Antworten. d′ fehlt, wo jede oder keine Antwort richtig ist. Korrigiertes d′: das von (richtige Antworten + 1/3)/(Durchgänge + 1), das bei jeder Anzahl richtiger Antworten endlich ist; die Mittelwerte über die Versuchspersonen sind solche des korrigierten d′.</translation>
    </message>
    <message>
        <source>With two alternatives the comparison as surface A is the signal, and d′ = d_a/√2.</source>
        <translation>Bei zwei Alternativen ist der Vergleichsreiz als Oberfläche A das Signal, und d′ = d_a/√2.</translation>
    </message>
    <message>
        <source>Same–different: d_a is not the d′ of the differencing rule but describes the distributions of the judged difference between the surfaces. Unequal variances are expected, because equal pairs and different pairs in both orders are judged by the absolute difference of two impressions.</source>
        <translation>Gleich–verschieden: d_a ist nicht das d′ der Differenzregel, sondern beschreibt die Verteilungen des beurteilten Unterschieds der Oberflächen. Ungleiche Varianzen sind zu erwarten, weil gleiche Paare und verschiedene Paare in beiden Reihenfolgen nach der absoluten Differenz zweier Eindrücke beurteilt werden.</translation>
    </message>
    <message>
        <source>%1 (at least; ceiling: %2 of %3 participants)</source>
        <translation>%1 (mindestens; Deckeneffekt: %2 von %3 Versuchspersonen)</translation>
    </message>
    <message>
        <source>There is no CI where its limits would differ by a factor of more than 100, because the responses hardly determine such a threshold.</source>
        <translation>Kein KI gibt es, wo sich seine Grenzen um mehr als den Faktor 100 unterscheiden würden, weil die Antworten eine solche Schwelle kaum bestimmen.</translation>
    </message>
    <message>
        <source>Weber fraction: JND divided by the standard. Thresholds outside the presented levels are not reported.</source>
        <translation>Weber-Bruch: JND geteilt durch den Standardreiz. Schwellen außerhalb der dargebotenen Stufen werden nicht berichtet.</translation>
    </message>
    <message>
        <source>Deviance with its degrees of freedom and p (χ²): goodness of fit, indicative only with few trials per level.</source>
        <translation>Devianz mit Freiheitsgraden und p (χ²): Anpassungsgüte, bei wenigen Durchgängen je Stufe nur ein Anhaltspunkt.</translation>
    </message>
    <message>
        <source>Dissimilarity of identical pairs</source>
        <translation>Unähnlichkeit identischer Paare</translation>
    </message>
    <message>
        <source>Mean dissimilarity of a surface and itself; 0 is the end of the scale for identical surfaces. Difference: mean dissimilarity of different surfaces minus that of identical ones. Means over participants with t-based 95 % CIs.</source>
        <translation>Mittlere Unähnlichkeit einer Oberfläche mit sich selbst; 0 ist das Ende der Skala für identische Oberflächen. Differenz: mittlere Unähnlichkeit verschiedener Oberflächen minus die identischer. Mittelwerte über die Versuchspersonen mit t-basierten 95-%-KIs.</translation>
    </message>
    <message>
        <source>Cross-validation chose one dimension; at least two are shown.</source>
        <translation>Die Kreuzvalidierung wählt eine Dimension; dargestellt werden mindestens zwei.</translation>
    </message>
    <message>
        <source>There is no exponent, because the predictor (%1) is computed from recordings, and none can be read for these responses. Record every tick (key &quot;recording&quot; of the protocol), and simulate participants with &quot;--recordings all&quot;.</source>
        <translation>Es gibt keinen Exponenten, weil der Prädiktor (%1) aus Aufzeichnungen berechnet wird und für diese Antworten keine lesbar ist. Jeden Takt aufzeichnen (Schlüssel „recording“ des Protokolls) und Teilnehmer mit „--recordings all“ simulieren.</translation>
    </message>
    <message>
        <source>The predictor (%1) is computed from recordings, and these are stored for only %2 of %3 participants. &quot;--recordings all&quot; of &quot;asperity simulate&quot; stores those of all virtual participants.</source>
        <translation>Der Prädiktor (%1) wird aus Aufzeichnungen berechnet, und diese sind nur für %2 von %3 Teilnehmern gespeichert. „--recordings all“ von „asperity simulate“ speichert die aller virtuellen Teilnehmer.</translation>
    </message>
    <message>
        <source>%1… (attempts: %2)</source>
        <translation>%1… (Versuche: %2)</translation>
    </message>
    <message>
        <source>Different builds of the plug-in of the force model %1 have the version %2, and the responses to them are pooled. Their SHA-256: %3. Raise the version of a plug-in whose forces have changed; exclude the attempts with a build that must not be pooled.</source>
        <translation>Verschiedene Builds des Plug-ins des Kraftmodells %1 haben die Version %2, und die Antworten dazu sind zusammengefasst. Ihre SHA-256: %3. Die Version eines Plug-ins erhöhen, dessen Kräfte sich geändert haben; Versuche mit einem Build ausschließen, der nicht zusammengefasst werden darf.</translation>
    </message>
    <message>
        <source>Same–different: there is no CI of d′ where it would contain negative values, which d′ cannot have by these rules.</source>
        <translation>Gleich–verschieden: d′ hat kein KI, wo dieses negative Werte enthielte, die d′ nach diesen Regeln nicht haben kann.</translation>
    </message>
    <message>
        <source>%1 Participants and levels without a row: %2, because all of their trials at the level had the comparison in the same position, or there were no trials without a signal.</source>
        <translation>%1 Versuchspersonen und Stufen ohne Zeile: %2, weil alle ihre Durchgänge auf der Stufe den Vergleichsreiz an derselben Position hatten oder es keine Durchgänge ohne Signal gab.</translation>
    </message>
    <message>
        <source>Hits are responses “different”; those at a difference of 0 are false alarms, to all pairs of equal surfaces: two standards, or two comparisons of any level.</source>
        <translation>Treffer sind Antworten „verschieden“; die bei einem Unterschied von 0 sind falsche Alarme bei allen Paaren gleicher Oberflächen: zwei Standardreizen oder zwei Vergleichsreizen einer beliebigen Stufe.</translation>
    </message>
    <message>
        <source>%1 The numbers of repetitions differ: the first %2 of each of the %3 repeated items are used.</source>
        <translation>%1 Die Anzahlen der Wiederholungen unterscheiden sich: Verwendet werden die ersten %2 von jedem der %3 wiederholten Items.</translation>
    </message>
    <message>
        <source>%1 (at most; floor: %2 of %3 participants)</source>
        <translation>%1 (höchstens; Bodeneffekt: %2 von %3 Versuchspersonen)</translation>
    </message>
    <message>
        <source>%1 (ceiling: %2, floor: %3 of %4 participants)</source>
        <translation>%1 (Deckeneffekt: %2, Bodeneffekt: %3 von %4 Versuchspersonen)</translation>
    </message>
    <message>
        <source>Ceiling: a proportion is 0 or 1, so that d′ of these participants depends on their numbers of trials; the mean is a lower bound and has no CI.</source>
        <translation>Deckeneffekt: Ein Anteil ist 0 oder 1, sodass d′ dieser Versuchspersonen von ihren Anzahlen von Durchgängen abhängt; der Mittelwert ist eine untere Schranke und hat kein KI.</translation>
    </message>
    <message>
        <source>Floor: a proportion is 0 or 1 and d′ is negative, so that d′ of these participants depends on their numbers of trials; the mean is an upper bound and has no CI.</source>
        <translation>Bodeneffekt: Ein Anteil ist 0 oder 1 und d′ negativ, sodass d′ dieser Versuchspersonen von ihren Anzahlen von Durchgängen abhängt; der Mittelwert ist eine obere Schranke und hat kein KI.</translation>
    </message>
    <message>
        <source>Ceiling and floor: without a correction, d′ of some participants is positive and infinite and that of others negative and infinite; the mean depends on their numbers of trials, is neither a lower nor an upper bound, and has no CI.</source>
        <translation>Decken- und Bodeneffekt: Ohne Korrektur ist d′ einiger Versuchspersonen positiv unendlich und das anderer negativ unendlich; der Mittelwert hängt von ihren Anzahlen von Durchgängen ab, ist weder eine untere noch eine obere Schranke und hat kein KI.</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1 By this decision rule d′ is not negative, and chance alone makes it greater than 0 for some participants: means of small d′ are too high. Participants with d′ = 0: %2.</source>
        <translation>%1 Nach dieser Entscheidungsregel ist d′ nicht negativ, und allein durch Zufall ist es bei einigen Versuchspersonen größer als 0: Mittelwerte kleiner d′ sind zu hoch. Versuchspersonen mit d′ = 0: %2.</translation>
    </message>
    <message>
        <source>The non-metric configuration is degenerate: %1 items lie on one point (%2), and their mean dissimilarities, on which its stress does not depend, are %3 to %4. The configuration of metric scaling is reported instead.</source>
        <translation>Die nichtmetrische Konfiguration ist degeneriert: %1 Items liegen auf einem Punkt (%2), und ihre mittleren Unähnlichkeiten, von denen ihr Stress nicht abhängt, sind %3 bis %4. Stattdessen wird die Konfiguration der metrischen Skalierung berichtet.</translation>
    </message>
    <message>
        <source>95 % CI with responses “cannot tell”: bootstrap percentiles, the three outcomes of each level being resampled %1 times and split again. There is no CI of the slope where that of more than 2.5 % of the resampled functions is at the bound of the fit, which would be its limit.</source>
        <translation>95-%-KI mit Antworten „nicht zu sagen“: Bootstrap-Perzentile; die drei Ergebnisse jeder Stufe werden %1-mal neu gezogen und wieder aufgeteilt. Die Steigung hat kein KI, wo die von mehr als 2,5 % der neu gezogenen Funktionen an der Grenze der Anpassung liegt, die dann seine Grenze wäre.</translation>
    </message>
    <message>
        <source>The JND, which follows from the slope, then has no CI either.</source>
        <translation>Die JND, die aus der Steigung folgt, hat dann ebenfalls kein KI.</translation>
    </message>
    <message>
        <source>%1 Left out of %2 thresholds: %3.</source>
        <translation>%1 Von %2 Schwellen ausgelassen: %3.</translation>
    </message>
    <message>
        <source>In simulations of responses “cannot tell” (two alternatives, 36 to 144 trials at five levels, 2000 tables per setting), the 95 % CI of the JND of a judgement of performance contained the true JND in 88 to 96 % of the tables; with 36 trials it is too narrow (88 to 91 %).</source>
        <translation>In Simulationen mit Antworten „kann es nicht sagen“ (zwei Alternativen, 36 bis 144 Durchgänge auf fünf Stufen, 2000 Tabellen je Einstellung) enthielt das 95-%-KI der JND eines Leistungsurteils die wahre JND in 88 bis 96 % der Tabellen; bei 36 Durchgängen ist es zu schmal (88 bis 91 %).</translation>
    </message>
    <message>
        <source>In simulations of responses “cannot tell” (36 to 144 trials at five levels, 2000 tables per setting), the 95 % CI of the JND of a comparison contained the true JND in 89 to 96 % of the tables that had one.</source>
        <translation>In Simulationen mit Antworten „kann es nicht sagen“ (36 bis 144 Durchgänge auf fünf Stufen, 2000 Tabellen je Einstellung) enthielt das 95-%-KI der JND eines Vergleichs die wahre JND in 89 bis 96 % der Tabellen, die eines hatten.</translation>
    </message>
    <message>
        <source>Each repetition presents other textures than the others: repetitions and textures cannot be distinguished. Differences between repetitions and changes over the trials are also differences between textures, and there is no reliability over repetitions.</source>
        <translation>Jede Wiederholung zeigt andere Texturen als die übrigen: Wiederholungen und Texturen lassen sich nicht unterscheiden. Unterschiede zwischen Wiederholungen und Veränderungen über die Durchgänge sind auch Unterschiede zwischen Texturen, und es gibt keine Reliabilität über Wiederholungen.</translation>
    </message>
    <message>
        <source>%1: mean A_z of %2 of %3 participants = %4</source>
        <translation>%1: mittleres A_z von %2 von %3 Versuchspersonen = %4</translation>
    </message>
    <message>
        <source>%1; mean area by trapezoids of %2 of %3 participants = %4</source>
        <translation>%1; mittlere Fläche nach der Trapezregel von %2 von %3 Versuchspersonen = %4</translation>
    </message>
    <message>
        <source>%1; of the pooled responses A_z = %2</source>
        <translation>%1; aller Antworten zusammen A_z = %2</translation>
    </message>
    <message>
        <source>ROC by the %1 of the comparison: %2. The area of pooled responses is too small where participants have different criteria: a common A_z of .856 becomes .81 and .77 if criteria differ with SDs of 0.7 and 1.0. The tests of equal variances are exploratory and uncorrected, and treat the responses of all participants as independent.</source>
        <translation>ROC nach %1 des Vergleichsreizes: %2. Die Fläche aller Antworten zusammen ist zu klein, wenn die Versuchspersonen verschiedene Kriterien haben: Ein gemeinsames A_z von 0,856 wird zu 0,81 und 0,77, wenn sich die Kriterien mit Standardabweichungen von 0,7 und 1,0 unterscheiden. Die Tests auf gleiche Varianzen sind explorativ und unkorrigiert und behandeln die Antworten aller Versuchspersonen als unabhängig.</translation>
    </message>
    <message>
        <source>Normal model with unequal variances of the categories of response and confidence, by maximum likelihood for each participant and over the responses of all participants; likelihood-ratio test of equal variances [Dorfman 1969]. Means of participants with t-based CIs, without one where a participant has no estimate: in simulations the coverage for A_z was 92 to 97 % and for the area by trapezoids 91 to 97 %. There is no CI of the pooled responses: in simulations in which participants had different criteria, that of a bootstrap over participants contained the common A_z in 12 to 87 % of the studies.</source>
        <translation>Normalverteilungsmodell mit ungleichen Varianzen für die Kategorien aus Antwort und Sicherheit, mit maximaler Likelihood für jede Versuchsperson und über die Antworten aller Versuchspersonen; Likelihood-Quotienten-Test auf gleiche Varianzen [Dorfman 1969]. Mittelwerte der Versuchspersonen mit t-basierten KIs, ohne KI, wenn eine Versuchsperson keinen Schätzwert hat: In Simulationen enthielten sie den wahren Wert von A_z in 92 bis 97 % und den der Fläche nach der Trapezregel in 91 bis 97 % der Studien. Die Antworten aller Versuchspersonen zusammen haben kein KI: In Simulationen, in denen die Versuchspersonen verschiedene Kriterien hatten, enthielt das eines Bootstraps über die Versuchspersonen das gemeinsame A_z in 12 bis 87 % der Studien.</translation>
    </message>
    <message>
        <source>Generalised linear mixed model (logit) with crossed random intercepts of participants and textures, by maximum likelihood with the Laplace approximation, or by numerical integration where one SD is estimated as 0; t test and CI of the fixed intercept, with the degrees of freedom of the smaller sample (participants or textures), also where its SD is estimated as 0. In simulations with 5 to 20 participants and SDs of 0.5 and 1, the coverage of the 95 % CI was 97 to 100 % with four textures and 94 to 100 % with ten for proportions of 25 to 80 %; for 95 %, where few studies have enough incorrect responses for an estimate, it was 89 to 99 % and 70 to 97 %.</source>
        <translation>Generalisiertes lineares gemischtes Modell (Logit) mit gekreuzten zufälligen Achsenabschnitten der Versuchspersonen und Texturen, mit maximaler Likelihood in der Laplace-Näherung, oder durch numerische Integration, wenn eine Standardabweichung als 0 geschätzt wird; t-Test und KI des festen Achsenabschnitts mit den Freiheitsgraden der kleineren Stichprobe (Versuchspersonen oder Texturen), auch wenn deren Standardabweichung als 0 geschätzt wird. In Simulationen mit 5 bis 20 Versuchspersonen und Standardabweichungen von 0,5 und 1 enthielt das 95-%-KI den wahren Wert bei Anteilen von 25 bis 80 % in 97 bis 100 % der Studien mit vier und in 94 bis 100 % mit zehn Texturen; bei 95 %, wo wenige Studien genug falsche Antworten für einen Schätzwert haben, in 89 bis 99 % und 70 bis 97 %.</translation>
    </message>
    <message>
        <source>Participants without a point of subjective equality within the presented levels are left out of its test</source>
        <translation>Versuchspersonen ohne einen Punkt subjektiver Gleichheit innerhalb der dargebotenen Stufen fehlen in seinem Test</translation>
    </message>
    <message>
        <source>ratio %1 / %2: %3</source>
        <translation>Verhältnis %1 / %2: %3</translation>
    </message>
    <message>
        <source>%1 Left out: %2 of %3 participants, who do not have a threshold within the presented levels in every condition; the comparison does not describe them.</source>
        <translation>%1 Ausgelassen: %2 von %3 Versuchspersonen, die nicht in jeder Bedingung eine Schwelle innerhalb der dargebotenen Stufen haben; der Vergleich beschreibt sie nicht.</translation>
    </message>
    <message>
        <source>%1 The thresholds and their CIs take the lapse rates of 2 % as known.</source>
        <translation>%1 Die Schwellen und ihre KIs setzen die Fehlerraten (lapse rates) von 2 % als bekannt voraus.</translation>
    </message>
    <message>
        <source>%1 The JNDs and their CIs take the lapse rates of 2 % as known: for participants who never lapse, simulated JNDs were too small by 11 to 13 %, and the CI of the mean contained the true JND in 22 to 95 % of the studies (91 to 96 % with lapse rates of 2 %).</source>
        <translation>%1 Die Unterschiedsschwellen und ihre KIs setzen die Fehlerraten (lapse rates) von 2 % als bekannt voraus: Bei Versuchspersonen ohne Aussetzer waren simulierte Unterschiedsschwellen um 11 bis 13 % zu klein, und das KI des Mittelwerts enthielt die wahre Unterschiedsschwelle in 22 bis 95 % der Studien (91 bis 96 % bei Fehlerraten (lapse rates) von 2 %).</translation>
    </message>
    <message>
        <source>No mean threshold is reported.</source>
        <translation>Es wird keine mittlere Schwelle angegeben.</translation>
    </message>
    <message>
        <source>No mean point of subjective equality is reported.</source>
        <translation>Es wird kein mittlerer Punkt subjektiver Gleichheit angegeben.</translation>
    </message>
    <message>
        <source>Wilcoxon signed-rank test of the thresholds of the participants with a threshold in both conditions. Ratio: geometric mean of the same participants&apos; ratios, with a t-based CI on the logarithmic scale.</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test der Schwellen der Versuchspersonen, die in beiden Bedingungen eine Schwelle haben. Verhältnis: geometrisches Mittel der Verhältnisse derselben Versuchspersonen mit t-basiertem KI auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>Friedman test of the thresholds of the participants with a threshold in every condition.</source>
        <translation>Friedman-Test der Schwellen der Versuchspersonen, die in jeder Bedingung eine Schwelle haben.</translation>
    </message>
    <message>
        <source>The CIs of means take lapse rates that are fixed at 2 % as known: in simulations of comparisons by participants who never lapse they contained the true JND in 22 to 95 % of the studies, in fewer of them the more participants and trials there were, and in 91 to 96 % with lapse rates of 2 %.</source>
        <translation>Die KIs der Mittelwerte setzen die auf 2 % festgelegten Fehlerraten (lapse rates) als bekannt voraus: In Simulationen von Vergleichen ohne Aussetzer enthielten sie die wahre Unterschiedsschwelle in 22 bis 95 % der Studien, in umso weniger, je mehr Versuchspersonen und Durchgänge es waren, und bei Fehlerraten (lapse rates) von 2 % in 91 bis 96 %.</translation>
    </message>
    <message>
        <source>A mean that leaves out thresholds is an upper bound if all of these lie below the presented levels, a lower bound if all lie above, and otherwise neither and not reported. It has no CI: in simulations in which 27 and 34 % of the thresholds were left out, the t-based CI of the others contained the true mean in 75 and 48 % of the studies.</source>
        <translation>Ein Mittelwert, der Schwellen auslässt, ist eine obere Schranke, wenn diese alle unterhalb der dargebotenen Stufen liegen, eine untere, wenn alle oberhalb liegen, und sonst keines von beiden und nicht angegeben. Er hat kein KI: In Simulationen, in denen 27 und 34 % der Schwellen ausgelassen waren, enthielt das t-basierte Intervall der übrigen den wahren Mittelwert in 75 und 48 % der Studien.</translation>
    </message>
    <message>
        <source>Linear mixed models of the natural logarithms [Laird &amp; Ware, 1982], fitted by restricted maximum likelihood (REML), with random intercepts of participants; F tests and t-based 95 % CIs with Satterthwaite’s degrees of freedom [Satterthwaite, 1946]. Ratios: to the reference level of a condition, per 10 trials of a block, per block or per session. The tests are exploratory and uncorrected. Tests are liberal and CIs too narrow where participants differ in these effects, which the models do not include: in simulations of ratings whose effects varied over participants (SDs of half and one residual SD) the F test had Type I error rates of up to 25 and 54 % at α = .05, and the CIs contained the true difference in 68 to 90 % of the studies. The position in a block is a covariate; its ratio is reported for blocks of ten trials or more, because it would otherwise be an extrapolation.</source>
        <translation>Lineare gemischte Modelle der natürlichen Logarithmen [Laird &amp; Ware, 1982], angepasst mit restringierter maximaler Likelihood (REML), mit zufälligen Achsenabschnitten der Versuchspersonen; F-Tests und t-basierte 95-%-KIs mit Freiheitsgraden nach Satterthwaite [Satterthwaite, 1946]. Verhältnisse: zur Bezugsstufe einer Bedingung, je 10 Durchgänge eines Blocks, je Block oder je Sitzung. Die Tests sind explorativ und unkorrigiert. Die Tests sind liberal und die KIs zu schmal, wenn sich die Versuchspersonen in diesen Effekten unterscheiden, was die Modelle nicht enthalten: In Simulationen von Einstufungen, deren Effekte über die Versuchspersonen variierten (Standardabweichungen von einer halben und einer ganzen Residuenstandardabweichung), hatte der F-Test Fehlerraten erster Art von bis zu 25 und 54 % bei α = 0,05, und die KIs enthielten die wahre Differenz in 68 bis 90 % der Studien. Der Platz im Block ist eine Kovariate; sein Verhältnis wird für Blöcke ab zehn Durchgängen angegeben, weil es sonst eine Extrapolation wäre.</translation>
    </message>
    <message>
        <source>%1 below the presented levels</source>
        <translation>%1 unterhalb der dargebotenen Stufen</translation>
    </message>
    <message>
        <source>%1 above the presented levels</source>
        <translation>%1 oberhalb der dargebotenen Stufen</translation>
    </message>
    <message>
        <source>%1 not estimated (%2)</source>
        <translation>%1 nicht geschätzt (%2)</translation>
    </message>
    <message>
        <source>the mean of the others is an upper bound and has no CI</source>
        <translation>der Mittelwert der übrigen ist eine obere Schranke und hat kein KI</translation>
    </message>
    <message>
        <source>the mean of the others is a lower bound and has no CI</source>
        <translation>der Mittelwert der übrigen ist eine untere Schranke und hat kein KI</translation>
    </message>
    <message>
        <source>the mean of the others is neither an upper nor a lower bound and is not reported</source>
        <translation>der Mittelwert der übrigen ist weder eine obere noch eine untere Schranke und wird nicht angegeben</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>%1 Left out of %2 thresholds in the condition %3: %4.</source>
        <translation>%1 Ausgelassen von %2 Schwellen in der Bedingung %3: %4.</translation>
    </message>
    <message>
        <source>The following pairs are confused equally often, and none more often: %1; number of confusions of each, counted in both directions: %2.</source>
        <translation>Die folgenden Paare werden gleich oft verwechselt, und keines öfter: %1; Zahl der Verwechslungen eines jeden, in beiden Richtungen gezählt: %2.</translation>
    </message>
    <message>
        <source>%1 α is negative where scales point in opposite directions: check which of them are reverse-keyed.</source>
        <translation>%1 α ist negativ, wenn Skalen in entgegengesetzte Richtungen weisen: Prüfen Sie, welche davon umgekehrt gepolt sind.</translation>
    </message>
    <message>
        <source>Cronbach’s α with the scales as test items, over the combinations of a participant and an item, after reverse-keyed scales were reflected. The CI is over draws of the participants; in simulations with 7 to 20 participants its coverage was 87 to 92 %.</source>
        <translation>Cronbachs α mit den Skalen als Testitems, über die Kombinationen aus einer Versuchsperson und einem Item, nachdem umgekehrt gepolte Skalen gespiegelt wurden. Das KI stammt von Ziehungen der Versuchspersonen; in Simulationen mit 7 bis 20 Versuchspersonen enthielt es den wahren Wert in 87 bis 92 % der Fälle.</translation>
    </message>
    <message>
        <source>Log odds ratio of a higher rating, relative to the reference: proportional odds, items as fixed effects, participants as random intercepts. Every response counts. There are no CIs and no p values: the model assumes the same effects of the items for all participants, and in simulations in which these varied with an SD of 0.5 its likelihood-ratio test had a Type I error rate of 21 % at α = .05.</source>
        <translation>Logarithmisches Chancenverhältnis einer höheren Einstufung gegenüber dem Bezug: proportionale Chancen, Items als feste Effekte, Versuchspersonen als zufällige Achsenabschnitte. Jede Antwort zählt. Es gibt keine KIs und keine p-Werte: Das Modell setzt für alle Versuchspersonen dieselben Effekte der Items voraus, und in Simulationen, in denen diese mit einer Standardabweichung von 0,5 variierten, hatte sein Likelihood-Quotienten-Test eine Fehlerrate erster Art von 21 % bei α = 0,05.</translation>
    </message>
    <message>
        <source>Differences of the mean ratings on each scale</source>
        <translation>Differenzen der mittleren Einstufungen auf jeder Skala</translation>
    </message>
    <message>
        <source>Differences of the participants’ mean ratings to the reference, over the participants who rated every item, with t-based 95 % CIs of the paired differences, uncorrected.</source>
        <translation>Differenzen der mittleren Einstufungen der Versuchspersonen zum Bezug, über die Versuchspersonen, die jedes Item eingestuft haben, mit t-basierten 95-%-KIs der gepaarten Differenzen, unkorrigiert.</translation>
    </message>
    <message>
        <source>Each participant&apos;s own intraclass correlation (consistency) of the logarithms of the estimates, with the surfaces in each condition as targets and the repetitions as raters; mean over the participants with a t-based CI. In simulations with 2 to 20 participants and seven surfaces, the coverage of the CI was at least 90 %.</source>
        <translation>Intraklassenkorrelation (Konsistenz) der Logarithmen der Schätzungen, für jede Versuchsperson einzeln, mit den Oberflächen in jeder Bedingung als Urteilsobjekten und den Wiederholungen als Beurteilern; Mittelwert über die Versuchspersonen mit einem t-basierten KI. In Simulationen mit 2 bis 20 Versuchspersonen und sieben Oberflächen enthielt es den wahren Mittelwert in mindestens 90 % der Studien.</translation>
    </message>
    <message>
        <source>Dissimilarity: the distance of the rating from the end of the scale for identical surfaces, mean over participants with a t-based 95 % CI; both orders together. Distance: in the configuration. Disparity: the regression of the distances on the mean dissimilarities, isotonic for non-metric and proportional for metric scaling.</source>
        <translation>Unähnlichkeit: Abstand der Einstufung vom Skalenende für identische Oberflächen, Mittelwert über die Versuchspersonen mit t-basiertem 95-%-KI; beide Reihenfolgen zusammen. Abstand: in der Konfiguration. Disparität: Regression der Abstände auf die mittleren Unähnlichkeiten, isoton bei nichtmetrischer und proportional bei metrischer Skalierung.</translation>
    </message>
    <message>
        <source>%1 Only distances can be interpreted. Half axes and angle: the 95 % ellipse of the position in the first two dimensions, from a bootstrap over participants.</source>
        <translation>%1 Nur Abstände sind deutbar. Halbachsen und Winkel: die 95-%-Ellipse der Lage in den ersten beiden Dimensionen, aus einem Bootstrap über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>Metric (ratio) multidimensional scaling, along the principal axes, because the non-metric configuration is degenerate; distances have the unit of the scale.</source>
        <translation>Metrische multidimensionale Skalierung (Verhältnisniveau), entlang der Hauptachsen, weil die nichtmetrische Konfiguration degeneriert ist; Abstände haben die Einheit der Skala.</translation>
    </message>
    <message>
        <source>Non-metric multidimensional scaling, along the principal axes; the mean square distance of two items is 1.</source>
        <translation>Nichtmetrische multidimensionale Skalierung, entlang der Hauptachsen; das mittlere Abstandsquadrat zweier Items ist 1.</translation>
    </message>
    <message>
        <source>Non-metric multidimensional scaling of the mean dissimilarities, or metric (ratio) scaling if the non-metric configuration is degenerate. Permutation test of its stress-1: ratings are permuted over the pairs within participants. The number of dimensions is chosen by cross-validation over participants.</source>
        <translation>Nichtmetrische multidimensionale Skalierung der mittleren Unähnlichkeiten, oder metrische (Verhältnisniveau), wenn die nichtmetrische Konfiguration degeneriert ist. Permutationstest ihres Stress-1: Die Einstufungen werden innerhalb der Versuchspersonen über die Paare permutiert. Die Zahl der Dimensionen wird durch Kreuzvalidierung über die Versuchspersonen gewählt.</translation>
    </message>
    <message>
        <source>The non-metric configuration is degenerate (different disparities: %1): it shows which items form clusters, and neither their distances nor the number of dimensions. The configuration of metric scaling is reported instead.</source>
        <translation>Die nichtmetrische Konfiguration ist degeneriert (verschiedene Disparitäten: %1): Sie zeigt, welche Items Cluster bilden, und weder deren Abstände noch die Zahl der Dimensionen. Stattdessen wird die Konfiguration der metrischen Skalierung angegeben.</translation>
    </message>
    <message>
        <source>Metric scaling, because the non-metric configuration is degenerate.</source>
        <translation>Metrische Skalierung, weil die nichtmetrische Konfiguration degeneriert ist.</translation>
    </message>
    <message>
        <source>Geometric means over the participants whose stimulus was matched, with t-based 95 % CIs on the logarithmic scale, and without a CI where a match did not succeed: the matched ones are then a selection (for thresholds within the levels such CIs contained the true mean in 48 to 75 % of simulated studies). The reference has the relative amplitude 1.</source>
        <translation>Geometrische Mittel über die Versuchspersonen, deren Reiz angeglichen wurde, mit t-basierten 95-%-KIs auf der logarithmischen Skala, und ohne KI, wenn eine Angleichung nicht gelang: Die angeglichenen sind dann eine Auswahl (bei Schwellen innerhalb der Stufen enthielten solche KIs den wahren Mittelwert in 48 bis 75 % der simulierten Studien). Der Bezugsreiz hat die relative Amplitude 1.</translation>
    </message>
    <message>
        <source>The components are those of the correlations of the scales over the items’ mean ratings. A component is retained if its eigenvalue and those of all components before it exceed the limit: the 95th percentile of the eigenvalues of tables of random numbers of the same size (parallel analysis). The deviations of single participants add variance to observed means, so that their first proportion and loadings are too small: corrected values are without this variance, if five participants or more rated every item on every scale; proportions have CIs by the jackknife over participants, which contained the true first proportion in 94 to 100 % of simulations. They do not generalise to other items. A percentile bootstrap contained the true first proportion in 0 to 32 % of simulations.</source>
        <translation>Die Komponenten sind die der Korrelationen der Skalen über die mittleren Einstufungen der Items. Eine Komponente wird beibehalten, wenn ihr Eigenwert und die aller Komponenten vor ihr die Grenze überschreiten: das 95. Perzentil der Eigenwerte von Tabellen gleich vieler Zufallszahlen (Parallelanalyse). Die Abweichungen einzelner Versuchspersonen vergrößern die Varianz beobachteter Mittelwerte, sodass ihr erster Anteil und ihre Ladungen zu klein sind: Korrigierte Werte sind ohne diese Varianz, wenn mindestens fünf Versuchspersonen jedes Item auf jeder Skala eingestuft haben; Anteile haben KIs nach dem Jackknife über die Versuchspersonen, die in 94 bis 100 % der Simulationen den wahren ersten Anteil enthielten. Sie gelten nicht für andere Items. Ein Perzentil-Bootstrap enthielt den wahren ersten Anteil in 0 bis 32 % der Simulationen.</translation>
    </message>
    <message>
        <source>A loading is the correlation of a scale with a component; corrected: without the variance of the participants’ deviations. It has no CI: in simulations that of the jackknife over participants contained the true loading in 60 to 97 % of the studies. A score is the position of an item on a component.</source>
        <translation>Eine Ladung ist die Korrelation einer Skala mit einer Komponente; korrigiert: ohne die Varianz der Abweichungen der Versuchspersonen. Sie hat kein KI: In Simulationen enthielt das nach dem Jackknife über die Versuchspersonen die wahre Ladung in 60 bis 97 % der Studien. Ein Komponentenwert ist die Lage eines Items auf einer Komponente.</translation>
    </message>
    <message>
        <source>Flagged attempts among those that count: %1; the reasons are in the trials of each session and in attempts.tsv of an export.</source>
        <translation>Markierte Versuche unter denen, die zählen: %1; die Gründe stehen bei den Durchgängen jeder Sitzung und in attempts.tsv eines Exports.</translation>
    </message>
    <message>
        <source>Means over the participants at the start, in the middle and at the end of a run of the block, and the change from the first to the last of these places. Runs without a response at both are left out; the mean in the middle is of those with a response there. Estimates: geometric means, and the ratio of the last to the first. The change is described and not tested.</source>
        <translation>Mittelwerte über die Versuchspersonen am Anfang, in der Mitte und am Ende eines Laufs des Blocks und die Veränderung von der ersten zur letzten dieser Stellen. Läufe, in denen an einer von beiden eine Antwort fehlt, sind ausgelassen; der Mittelwert in der Mitte ist der jener mit einer Antwort dort. Schätzungen: geometrische Mittel und das Verhältnis der letzten zur ersten. Die Veränderung wird beschrieben und nicht getestet.</translation>
    </message>
    <message>
        <source>95 % CI: t-based over participants, for estimates on the logarithmic scale; in simulations with 2 to 20 participants, its coverage was 94 to 100 %, and 92 to 100 % for ratings near an end of their scale.</source>
        <translation>95-%-KI: t-basiert über die Versuchspersonen, für Schätzungen auf der logarithmischen Skala; in Simulationen mit 2 bis 20 Versuchspersonen enthielt es den wahren Wert in 94 bis 100 % der Studien, bei Urteilen nahe einem Ende ihrer Skala in 92 bis 100 %.</translation>
    </message>
    <message>
        <source>Responses to anchors</source>
        <translation>Antworten auf Anker</translation>
    </message>
    <message>
        <source>Anchors are reference trials at fixed places of every run of a block. Only the tables of anchors contain their responses; no finding and no test does.</source>
        <translation>Anker sind Vergleichsdurchgänge an festen Stellen jedes Laufs eines Blocks. Nur die Tabellen der Anker enthalten ihre Antworten, kein Ergebnis und kein Test.</translation>
    </message>
    <message>
        <source>Change of the responses to anchors</source>
        <translation>Veränderung der Antworten auf Anker</translation>
    </message>
    <message>
        <source>The participants of all groups are analysed together.</source>
        <translation>Die Versuchspersonen aller Gruppen werden gemeinsam ausgewertet.</translation>
    </message>
    <message>
        <source>Changes of proportions correct have no CI, because each participant has only one trial at a place: in simulations with 2 to 20 participants, the coverage of a t-based CI was 92 to 100 %.</source>
        <translation>Veränderungen von Anteilen richtiger Antworten haben kein KI, weil jede Versuchsperson an einer Stelle nur einen Durchgang hat: In Simulationen mit 2 bis 20 Versuchspersonen enthielt ein t-basiertes KI die wahre Veränderung in 92 bis 100 % der Studien.</translation>
    </message>
    <message>
        <source>Response and confidence together are ordered categories. Area: by trapezoids, 95 % CI [DeLong 1988], truncated to 0 to 1; in simulations of one participant with 24 to 144 trials of either kind, its coverage was 88 to 95 %. A_z, d_a and the SD of the signal divided by that of the noise: normal model with unequal variances. χ²(1) and p: likelihood-ratio test of equal variances, exploratory and uncorrected; all responses are treated as independent. The rows of all participants assume equal criteria of the participants; an area over participants with different criteria is too small and has no CI: in simulations that of a bootstrap over participants contained the common A_z in 12 to 87 % of the studies, and DeLong’s the common area by trapezoids in 14 to 80 %. There is no CI of an area by trapezoids of 0 or 1, whose standard error is 0, so that the CI would be the area itself (coverage 0 %), and none where all trials with a signal, or all without one, have the same rating, because DeLong’s standard error is then too small.</source>
        <translation>Antwort und Sicherheit zusammen sind geordnete Kategorien. Fläche: nach der Trapezregel, 95-%-KI [DeLong 1988], auf 0 bis 1 begrenzt; in Simulationen einer Versuchsperson mit je 24 bis 144 Durchgängen mit und ohne Signal enthielt es die wahre Fläche in 88 bis 95 % der Tabellen. A_z, d_a und die Standardabweichung des Signals geteilt durch die des Rauschens: Normalverteilungsmodell mit ungleichen Varianzen. χ²(1) und p: Likelihood-Quotienten-Test auf gleiche Varianzen, explorativ und unkorrigiert; alle Antworten gelten als unabhängig. Die Zeilen aller Versuchspersonen setzen gleiche Kriterien voraus; die Fläche über Versuchspersonen mit verschiedenen Kriterien ist zu klein und hat kein KI: In Simulationen enthielt das eines Bootstraps über die Versuchspersonen das gemeinsame A_z in 12 bis 87 % der Studien und das nach DeLong die gemeinsame Fläche nach der Trapezregel in 14 bis 80 %. Kein KI hat eine Fläche nach der Trapezregel von 0 oder 1, deren Standardfehler 0 ist, sodass das KI die Fläche selbst wäre und die wahre nie enthielte, und keines eine, bei der alle Durchgänge mit oder alle ohne Signal dieselbe Einstufung haben, weil der Standardfehler nach DeLong dann zu klein ist.</translation>
    </message>
    <message>
        <source>the geometric mean of the thresholds</source>
        <translation>das geometrische Mittel der Schwellen</translation>
    </message>
    <message>
        <source>which items are chosen</source>
        <translation>welche Objekte gewählt werden</translation>
    </message>
    <message>
        <source>the mean rating on the scale “%1”</source>
        <translation>die mittlere Beurteilung auf der Skala „%1“</translation>
    </message>
    <message>
        <source>how the ratings on the scale “%1” differ between the items</source>
        <translation>wie sich die Beurteilungen der Objekte auf der Skala „%1“ unterscheiden</translation>
    </message>
    <message>
        <source>which pairs of surfaces are rated as more dissimilar</source>
        <translation>welche Paare von Oberflächen als unähnlicher beurteilt werden</translation>
    </message>
    <message>
        <source>how the estimates depend on the stimuli</source>
        <translation>wie die Schätzungen von den Stimuli abhängen</translation>
    </message>
    <message>
        <source>The permutation test uses all permutations of the group labels.</source>
        <translation>Der Permutationstest verwendet alle Permutationen der Gruppenzugehörigkeit.</translation>
    </message>
    <message>
        <source>The permutation test uses %1 permutations of the group labels drawn at random, because there are too many to enumerate.</source>
        <translation>Der Permutationstest verwendet %1 zufällig gezogene Permutationen der Gruppenzugehörigkeit, weil es zu viele gibt, um alle zu verwenden.</translation>
    </message>
    <message>
        <source>Do the groups %1 and %2 differ in %3?</source>
        <translation>Unterscheiden sich die Gruppen %1 und %2 hierin: %3?</translation>
    </message>
    <message>
        <source>difference (%1 − %2): %3</source>
        <translation>Differenz (%1 − %2): %3</translation>
    </message>
    <message>
        <source>the largest difference (%1 − %2), each participant&apos;s mean removed, is that of %3, %4</source>
        <translation>die größte Differenz (%1 − %2), ohne den Mittelwert jeder Versuchsperson, ist die von %3, %4</translation>
    </message>
    <message>
        <source>Means of the groups</source>
        <translation>Mittelwerte der Gruppen</translation>
    </message>
    <message>
        <source>Profiles of the groups</source>
        <translation>Profile der Gruppen</translation>
    </message>
    <message>
        <source>Means of the participants&apos; numbers, without each participant&apos;s own mean, in the first and second of the groups; their difference with Welch&apos;s 95 % CI, without correction for the number of items.</source>
        <translation>Mittelwerte der Zahlen der Versuchspersonen, ohne den Mittelwert jeder Versuchsperson, in der ersten und der zweiten der Gruppen; ihre Differenz mit dem 95-%-KI nach Welch, ohne Korrektur für die Anzahl der Objekte.</translation>
    </message>
    <message>
        <source>the mean exponent</source>
        <translation>der mittlere Exponent</translation>
    </message>
    <message>
        <source>the mean exponent (%1)</source>
        <translation>der mittlere Exponent (%1)</translation>
    </message>
    <message>
        <source>%1 in the group %2 (n = %3)</source>
        <translation>%1 in der Gruppe %2 (n = %3)</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>the mean d′</source>
        <translation>das mittlere d′</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 The ratio therefore has no CI, and may differ from that of all participants.</source>
        <translation>%1 Das Verhältnis hat daher kein KI und kann von dem aller Versuchspersonen abweichen.</translation>
    </message>
    <message>
        <source>Participants without a number for every item are left out of the test of the %1</source>
        <translation>Versuchspersonen, von denen nicht zu jedem Objekt eine Zahl vorliegt, sind von diesem Test ausgenommen: %1</translation>
    </message>
    <message>
        <source>Participants for whom this number is missing are left out of the test of the %1</source>
        <translation>Versuchspersonen, für die diese Zahl fehlt, sind von diesem Test ausgenommen: %1</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>%1 Left out: %2 of %3 participants, for whom this number is missing; the comparison does not describe them and therefore has no CI.</source>
        <translation>%1 Ausgelassen: %2 von %3 Versuchspersonen, für die diese Zahl fehlt; der Vergleich beschreibt sie nicht und hat daher kein KI.</translation>
    </message>
    <message>
        <source>%1 The CIs of the means are t-based; that of the %2 is Welch&apos;s CI.</source>
        <translation>%1 Die KIs der Mittelwerte beruhen auf der t-Verteilung; das KI nach Welch gehört zum Effekt (%2).</translation>
    </message>
    <message>
        <source>%1 Left out: %2 of %3 participants, who do not have a number for every item; the comparison does not describe them and therefore has no CI.</source>
        <translation>%1 Ausgelassen: %2 von %3 Versuchspersonen, von denen nicht zu jedem Objekt eine Zahl vorliegt; der Vergleich beschreibt sie nicht und hat daher kein KI.</translation>
    </message>
    <message>
        <source>From each participant&apos;s numbers the participant&apos;s mean is subtracted, so that what is compared is how they differ between items. Whole participants are permuted. %1 Where the groups are equal, R² is %2 on average.</source>
        <translation>Von den Zahlen jeder Versuchsperson wird ihr Mittelwert abgezogen, sodass verglichen wird, wie sie sich zwischen den Objekten unterscheiden. Permutiert werden ganze Versuchspersonen. %1 Wo die Gruppen gleich sind, ist R² im Mittel %2.</translation>
    </message>
    <message>
        <source>Means of the participants of each group, geometric where a ratio is compared, with t-based 95 % CIs. left out: participants for whom the number is missing; where there are any, there is no CI.</source>
        <translation>Mittelwerte der Versuchspersonen jeder Gruppe, geometrisch, wo ein Verhältnis verglichen wird, mit 95-%-KIs nach der t-Verteilung. ausgelassen: Versuchspersonen, für die die Zahl fehlt; wo es welche gibt, gibt es kein KI.</translation>
    </message>
    <message>
        <source>geometric mean thresholds of %1 participants: %2 (%3).</source>
        <translation>geometrische Mittel der Schwellen von %1 Versuchspersonen: %2 (%3).</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>On average, %1</source>
        <translation>Im Mittel gilt: %1</translation>
    </message>
    <message>
        <source>on average %1 of a participant&apos;s items were matched correctly (%2), compared with a chance level of %3; permutation test over participants, %4.</source>
        <translation>Im Mittel waren %1 der Zuordnungen einer Versuchsperson richtig (%2), bei einem Zufallsniveau von %3; Permutationstest über die Versuchspersonen, %4.</translation>
    </message>
    <message>
        <source>Not significantly above chance: %1</source>
        <translation>Nicht signifikant über dem Zufallsniveau: %1</translation>
    </message>
    <message>
        <source>%1 was chosen most often, in %2 of its comparisons (%3), and %4 least often, in %5 (%6). Friedman test: %7.</source>
        <translation>%1 wurde am häufigsten gewählt, in %2 seiner Vergleiche (%3), und %4 am seltensten, in %5 (%6). Friedman-Test: %7.</translation>
    </message>
    <message>
        <source>the mean rating is highest for %1, %2, and lowest for %3, %4. Friedman test: %5.</source>
        <translation>Das mittlere Urteil ist für %1 am höchsten, %2, und für %3 am niedrigsten, %4. Friedman-Test: %5.</translation>
    </message>
    <message>
        <source>on average %1 of a participant&apos;s responses were correct (%2), compared with a chance level of %3; %4.</source>
        <translation>Im Mittel waren %1 der Antworten einer Versuchsperson richtig (%2), bei einem Zufallsniveau von %3; %4.</translation>
    </message>
    <message>
        <source>No, significantly below chance: %1</source>
        <translation>Nein, signifikant unter dem Zufallsniveau: %1</translation>
    </message>
    <message>
        <source>Yes: %1</source>
        <translation>Ja: %1</translation>
    </message>
    <message>
        <source>the configuration in %1 dimensions has a stress-1 of %2, and that of permuted ratings is %3 on average. Permutation test: %4.</source>
        <translation>Die Konfiguration in %1 Dimensionen hat einen Stress-1 von %2, und der permutierter Urteile beträgt im Mittel %3. Permutationstest: %4.</translation>
    </message>
    <message>
        <source>the 95 % CI of the mean contains the chance level</source>
        <translation>das 95-%-Konfidenzintervall des Mittelwerts enthält das Zufallsniveau</translation>
    </message>
    <message>
        <source>the 95 % CI of the ratio contains 1</source>
        <translation>das 95-%-Konfidenzintervall des Verhältnisses enthält 1</translation>
    </message>
    <message>
        <source>the 95 % CI of the difference contains 0</source>
        <translation>das 95-%-Konfidenzintervall der Differenz enthält 0</translation>
    </message>
    <message>
        <source>%1 Nothing is established: p is below .05, but %2; more participants are needed.</source>
        <translation>%1 Belegt ist nichts: p liegt unter 0,05, aber %2; es sind mehr Versuchspersonen nötig.</translation>
    </message>
    <message>
        <source>%1 This does not show that they are equal.</source>
        <translation>%1 Das zeigt nicht, dass sie gleich sind.</translation>
    </message>
    <message>
        <source>Not significantly: %1</source>
        <translation>Nicht signifikant: %1</translation>
    </message>
    <message>
        <source>For these participants, %1</source>
        <translation>Bei diesen Versuchspersonen: %1</translation>
    </message>
    <message>
        <source>%1; %2. Permutation test of group labels: %3.</source>
        <translation>%1; %2. Permutationstest der Gruppenzugehörigkeit: %3.</translation>
    </message>
    <message>
        <source>a proportion R² = %1 of the variation of the profiles is between the groups; %2. Permutation test of group labels: %3.</source>
        <translation>ein Anteil R² = %1 der Variation der Profile liegt zwischen den Gruppen; %2. Permutationstest der Gruppenzugehörigkeit: %3.</translation>
    </message>
    <message>
        <source>%1; difference (%4 − %5) %2. Permutation test of group labels: %3.</source>
        <translation>%1; Differenz (%4 − %5) %2. Permutationstest der Gruppenzugehörigkeit: %3.</translation>
    </message>
    <message>
        <source>test of equal proportions of %1 with every texture: %2.</source>
        <translation>Test auf gleiche Anteile von %1 bei jeder Textur: %2.</translation>
    </message>
    <message>
        <source>the 95 % CI of the mean contains the standard</source>
        <translation>das 95-%-Konfidenzintervall des Mittelwerts enthält den Standardreiz</translation>
    </message>
    <message>
        <source>difference from the standard, %1: %2.</source>
        <translation>Unterschied zum Standardreiz, %1: %2.</translation>
    </message>
    <message>
        <source>Significant %1</source>
        <translation>Signifikanter %1</translation>
    </message>
    <message>
        <source>No significant %1</source>
        <translation>Kein signifikanter %1</translation>
    </message>
    <message>
        <source>Test of the %1</source>
        <translation>Test auf %1</translation>
    </message>
    <message>
        <source>%1 on average (1 divided by the number of items, which differs between trials)</source>
        <translation>im Mittel %1 (1 geteilt durch die Anzahl der Zuordnungen, die sich zwischen den Durchgängen unterscheidet)</translation>
    </message>
    <message>
        <source>Only one participant named a picture: %1 of these responses were correct (%2), compared with a chance level of %3; this cannot be tested with one participant.</source>
        <translation>Nur eine Versuchsperson gab ein Bild an: %1 dieser Antworten waren richtig (%2), bei einem Zufallsniveau von %3; mit einer Versuchsperson ist kein Test möglich.</translation>
    </message>
    <message>
        <source>%1 “Cannot tell” responses name no picture and are left out here; in the table of proportions they count as incorrect.</source>
        <translation>%1 Antworten „kann es nicht sagen“ geben kein Bild an und sind hier weggelassen; in der Tabelle der Anteile zählen sie als falsch.</translation>
    </message>
    <message>
        <source>the means do not differ in the direction of the test</source>
        <translation>die Mittelwerte unterscheiden sich nicht in der Richtung des Tests</translation>
    </message>
    <message>
        <source>Not established: %1 The test is significant, but %3; more participants are needed.</source>
        <translation>Nicht gesichert: %1 Der Test ist signifikant, doch %3; es werden mehr Versuchspersonen benötigt.</translation>
    </message>
    <message>
        <source>mean difference %1, N = %2, paired t test: %3.</source>
        <translation>mittlere Differenz %1, N = %2, t-Test für gepaarte Stichproben: %3.</translation>
    </message>
    <message>
        <source>They differ significantly: %1</source>
        <translation>Sie unterscheiden sich signifikant: %1</translation>
    </message>
    <message>
        <source>They do not differ significantly: %1</source>
        <translation>Sie unterscheiden sich nicht signifikant: %1</translation>
    </message>
    <message>
        <source>%1 Labels are exchanged only within the blocks in which the groups were assigned.</source>
        <translation>%1 Die Gruppen werden nur innerhalb der Blöcke vertauscht, in denen sie zugeteilt wurden.</translation>
    </message>
    <message>
        <source>Not established: %1 (%2). The test is significant, but %3; more participants are needed.</source>
        <translation>Nicht gesichert: %1 (%2). Der Test ist signifikant, doch %3; es werden mehr Versuchspersonen benötigt.</translation>
    </message>
    <message>
        <source>%1. Test of equal proportions: %2.</source>
        <translation>%1. Test auf gleiche Anteile: %2.</translation>
    </message>
    <message>
        <source>Not established: %1.</source>
        <translation>Nicht gesichert: %1.</translation>
    </message>
    <message>
        <source>%1, but %2</source>
        <translation>%1, doch %2</translation>
    </message>
    <message>
        <source>The position has a significant effect (%2): %1.</source>
        <translation>Die Position hat einen signifikanten Einfluss (%2): %1.</translation>
    </message>
    <message>
        <source>The position has no significant effect (%2): %1.</source>
        <translation>Die Position hat keinen signifikanten Einfluss (%2): %1.</translation>
    </message>
    <message>
        <source>Test of equal proportions: %2; %1.</source>
        <translation>Test auf gleiche Anteile: %2; %1.</translation>
    </message>
    <message>
        <source>The alternatives differ in %1 alone: these results are choices and do not show whether the levels can be discriminated.</source>
        <translation>Die Alternativen unterscheiden sich nur in %1: Diese Ergebnisse sind Wahlen und zeigen nicht, ob sich die Stufen unterscheiden lassen.</translation>
    </message>
    <message>
        <source>%1 Participants were asked: “%2”</source>
        <translation>%1 Die Versuchspersonen wurden gefragt: „%2“</translation>
    </message>
    <message>
        <source>Which level of %1 is chosen most often?</source>
        <translation>Welche Stufe von %1 wird am häufigsten gewählt?</translation>
    </message>
    <message>
        <source>Which rendering is chosen most often?</source>
        <translation>Welche Wiedergabe wird am häufigsten gewählt?</translation>
    </message>
    <message>
        <source>Is one level of %1 chosen more often than another?</source>
        <translation>Wird eine Stufe von %1 häufiger gewählt als eine andere?</translation>
    </message>
    <message>
        <source>Is one rendering chosen more often than another?</source>
        <translation>Wird eine Wiedergabe häufiger gewählt als eine andere?</translation>
    </message>
    <message>
        <source>Does the proportion of choices of %1 depend on the texture?</source>
        <translation>Hängt der Anteil der Wahlen von %1 von der Textur ab?</translation>
    </message>
    <message>
        <source>Participants who did not compare every pair equally often are left out of the test of the choices of the items</source>
        <translation>Versuchspersonen, die nicht jedes Paar gleich häufig verglichen haben, bleiben im Test der Wahlen der Items unberücksichtigt</translation>
    </message>
    <message>
        <source>The same test as for the models, with positions in their place.</source>
        <translation>Derselbe Test wie bei den Modellen, mit Positionen an deren Stelle.</translation>
    </message>
</context>
<context>
    <name>AnalysisPage</name>
    <message>
        <source>%1 Enter them with Study → Metadata…</source>
        <translation>%1 Sie lassen sich mit Studie → Metadaten… eintragen.</translation>
    </message>
</context>
<context>
    <name>AnalysisWords</name>
    <message>
        <source>other item</source>
        <translation>andere Antwort</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>Clopper–Pearson 95 % CI</source>
        <translation>Clopper-Pearson-95-%-KI</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>item</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>total</source>
        <translation>Gesamtzahl</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Wilson 95 % CI</source>
        <translation>Wilson-95-%-KI</translation>
    </message>
    <message>
        <source>Female</source>
        <translation>Frauen</translation>
    </message>
    <message>
        <source>Male</source>
        <translation>Männer</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>dissimilarity</source>
        <translation>Unähnlichkeit</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erste</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>join</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>log-worth</source>
        <translation>Log-Nutzwert</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p, Holm</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>second</source>
        <translation>zweite</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>worth</source>
        <translation>Nutzwert</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>descending</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>df₁</source>
        <translation>df₁</translation>
    </message>
    <message>
        <source>df₂</source>
        <translation>df₂</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>ε</source>
        <translation>ε</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>inverted U</source>
        <translation>umgekehrtes U</translation>
    </message>
    <message>
        <source>normalised</source>
        <translation>normiert</translation>
    </message>
    <message>
        <source>partial η²</source>
        <translation>partielles η²</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>roh</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>pair</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>p, interior maximum</source>
        <translation>p, inneres Maximum</translation>
    </message>
    <message>
        <source>smallest attainable p</source>
        <translation>kleinstes erreichbares p</translation>
    </message>
    <message>
        <source>R²</source>
        <translation>R²</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>statistic</source>
        <translation>Teststatistik</translation>
    </message>
    <message>
        <source>expected under guessing</source>
        <translation>beim Raten erwartet</translation>
    </message>
    <message>
        <source>chance level</source>
        <translation>Zufallsniveau</translation>
    </message>
    <message>
        <source>repetition</source>
        <translation>Wiederholung</translation>
    </message>
    <message>
        <source>confusions with the other</source>
        <translation>Verwechslungen mit der anderen</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>reverse confusions</source>
        <translation>umgekehrte Verwechslungen</translation>
    </message>
    <message>
        <source>participant</source>
        <translation>Versuchsperson</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>proportion</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>repetition %1</source>
        <translation>Wiederholung %1</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>first half</source>
        <translation>erste Hälfte</translation>
    </message>
    <message>
        <source>second half</source>
        <translation>zweite Hälfte</translation>
    </message>
    <message>
        <source>responses</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>95 % interval under guessing</source>
        <translation>95-%-Intervall beim Raten</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>Reiz</translation>
    </message>
    <message>
        <source>component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>eigenvalue</source>
        <translation>Eigenwert</translation>
    </message>
    <message>
        <source>label of the maximum</source>
        <translation>Beschriftung des Maximums</translation>
    </message>
    <message>
        <source>items</source>
        <translation>Items</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>log odds ratio</source>
        <translation>Log-Odds-Ratio</translation>
    </message>
    <message>
        <source>label of the minimum</source>
        <translation>Beschriftung des Minimums</translation>
    </message>
    <message>
        <source>mean rank</source>
        <translation>mittlerer Rang</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>retained</source>
        <translation>beibehalten</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>circular triads</source>
        <translation>zirkuläre Triaden</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>ties</source>
        <translation>Gleichstände</translation>
    </message>
    <message>
        <source>ζ</source>
        <translation>ζ</translation>
    </message>
    <message>
        <source>trials grouped by</source>
        <translation>Durchgänge gruppiert nach</translation>
    </message>
    <message>
        <source>question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>responses, comparison first</source>
        <translation>Antworten, Vergleichsreiz zuerst</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>JND at d′ = 1</source>
        <translation>JND bei d′ = 1</translation>
    </message>
    <message>
        <source>JND, posterior mean</source>
        <translation>JND, A-posteriori-Mittel</translation>
    </message>
    <message>
        <source>JND, posterior, 95 % CrI</source>
        <translation>JND, a posteriori, 95-%-Glaubwürdigkeitsintervall</translation>
    </message>
    <message>
        <source>PSE</source>
        <translation>PSE</translation>
    </message>
    <message>
        <source>deviance</source>
        <translation>Devianz</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>hits</source>
        <translation>Treffer</translation>
    </message>
    <message>
        <source>responses, comparison second</source>
        <translation>Antworten, Vergleichsreiz als Zweites</translation>
    </message>
    <message>
        <source>comparison chosen, first</source>
        <translation>Vergleichsreiz gewählt, zuerst</translation>
    </message>
    <message>
        <source>comparison chosen, second</source>
        <translation>Vergleichsreiz gewählt, als Zweites</translation>
    </message>
    <message>
        <source>task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>Treffer</translation>
    </message>
    <message>
        <source>trial of the track</source>
        <translation>Durchgang der Folge (Track)</translation>
    </message>
    <message>
        <source>track</source>
        <translation>Folge (Track)</translation>
    </message>
    <message>
        <source>number of the block</source>
        <translation>Nummer des Blocks</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>repetitions without threshold</source>
        <translation>Wiederholungen ohne Schwelle</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>geometric mean</source>
        <translation>geometrisches Mittel</translation>
    </message>
    <message>
        <source>unfinished tracks</source>
        <translation>unvollständige Folgen (Tracks)</translation>
    </message>
    <message>
        <source>Cronbach’s α</source>
        <translation>Cronbachs α</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>construct</source>
        <translation>Konstrukt</translation>
    </message>
    <message>
        <source>reverse-keyed</source>
        <translation>umgepolt</translation>
    </message>
    <message>
        <source>scales</source>
        <translation>Skalen</translation>
    </message>
    <message>
        <source>odds ratio</source>
        <translation>Odds-Ratio</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>criterion k, differencing</source>
        <translation>Kriterium k, Differenzregel</translation>
    </message>
    <message>
        <source>d′</source>
        <translation>d′</translation>
    </message>
    <message>
        <source>d′, independent observations</source>
        <translation>d′, unabhängige Beobachtungen</translation>
    </message>
    <message>
        <source>responses “different”</source>
        <translation>Antworten „verschieden“</translation>
    </message>
    <message>
        <source>false-alarm rate</source>
        <translation>Rate falscher Alarme</translation>
    </message>
    <message>
        <source>hit rate</source>
        <translation>Trefferrate</translation>
    </message>
    <message>
        <source>trials without a signal</source>
        <translation>Durchgänge ohne Signal</translation>
    </message>
    <message>
        <source>trials with a signal</source>
        <translation>Durchgänge mit Signal</translation>
    </message>
    <message>
        <source>squared error above the smallest</source>
        <translation>quadrierter Fehler über dem kleinsten</translation>
    </message>
    <message>
        <source>its standard error</source>
        <translation>dessen Standardfehler</translation>
    </message>
    <message>
        <source>r with the other participants</source>
        <translation>r mit den anderen Versuchspersonen</translation>
    </message>
    <message>
        <source>dimensions</source>
        <translation>Dimensionen</translation>
    </message>
    <message>
        <source>disparity</source>
        <translation>Disparität</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>ellipse, major half axis</source>
        <translation>Ellipse, große Halbachse</translation>
    </message>
    <message>
        <source>ellipse, minor half axis</source>
        <translation>Ellipse, kleine Halbachse</translation>
    </message>
    <message>
        <source>stress-1, metric</source>
        <translation>Stress-1, metrisch</translation>
    </message>
    <message>
        <source>r of both orders</source>
        <translation>r beider Reihenfolgen</translation>
    </message>
    <message>
        <source>prediction error</source>
        <translation>Vorhersagefehler</translation>
    </message>
    <message>
        <source>property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>r of repeated ratings</source>
        <translation>r wiederholter Urteile</translation>
    </message>
    <message>
        <source>stress-1</source>
        <translation>Stress-1</translation>
    </message>
    <message>
        <source>dimension %1</source>
        <translation>Dimension %1</translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
    <message>
        <source>responses “cannot tell”</source>
        <translation>Antworten „kann es nicht sagen“</translation>
    </message>
    <message>
        <source>A chosen</source>
        <translation>A gewählt</translation>
    </message>
    <message>
        <source>B chosen</source>
        <translation>B gewählt</translation>
    </message>
    <message>
        <source>C chosen</source>
        <translation>C gewählt</translation>
    </message>
    <message>
        <source>A_z</source>
        <translation>A_z</translation>
    </message>
    <message>
        <source>χ²(1)</source>
        <translation>χ²(1)</translation>
    </message>
    <message>
        <source>d_a</source>
        <translation>d_a</translation>
    </message>
    <message>
        <source>area under the ROC</source>
        <translation>Fläche unter der ROC</translation>
    </message>
    <message>
        <source>SD of signal/noise</source>
        <translation>SD von Signal/Rauschen</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>predictor</source>
        <translation>Prädiktor</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>d′, corrected</source>
        <translation>d′, korrigiert</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>korrigiert</translation>
    </message>
    <message>
        <source>proportion, corrected</source>
        <translation>Anteil, korrigiert</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Fieller 95 % CI</source>
        <translation>Fieller-95-%-KI</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>response time</source>
        <translation>Reaktionszeit</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>effect size [95 % CI]</source>
        <translation>Effektstärke [95-%-KI]</translation>
    </message>
    <message>
        <source>intended, mean</source>
        <translation>angestrebt, Mittelwert</translation>
    </message>
    <message>
        <source>achieved, mean</source>
        <translation>erreicht, Mittelwert</translation>
    </message>
    <message>
        <source>achieved, SD</source>
        <translation>erreicht, SD</translation>
    </message>
    <message>
        <source>achieved, minimum</source>
        <translation>erreicht, Minimum</translation>
    </message>
    <message>
        <source>achieved, maximum</source>
        <translation>erreicht, Maximum</translation>
    </message>
    <message>
        <source>relative amplitude</source>
        <translation>relative Amplitude</translation>
    </message>
    <message>
        <source>roughness match</source>
        <translation>Rauheitsabgleich</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
</context>
<context>
    <name>AttemptWords</name>
    <message>
        <source>flagged</source>
        <translation>markiert</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>included again</source>
        <translation>wieder eingeschlossen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>block %1</source>
        <translation>Block %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>took %1</source>
        <translation>dauerte %1</translation>
    </message>
    <message>
        <source>Not counted: %1</source>
        <translation>Nicht gezählt: %1</translation>
    </message>
    <message>
        <source>Excluded with its whole session: %1</source>
        <translation>Mit der ganzen Sitzung ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>Excluded: %1</source>
        <translation>Ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>Counted in the analyses</source>
        <translation>In den Auswertungen gezählt</translation>
    </message>
    <message>
        <source>Counted but flagged: %1</source>
        <translation>Gezählt, aber markiert: %1</translation>
    </message>
    <message>
        <source>flagged: %1</source>
        <translation>markiert: %1</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Trial %1, attempt %2 · %3</source>
        <translation>Durchgang %1, Versuch %2 · %3</translation>
    </message>
    <message>
        <source>Session %1</source>
        <translation>Sitzung %1</translation>
    </message>
    <message>
        <source>After contact, s</source>
        <translation>Nach Kontakt, s</translation>
    </message>
    <message>
        <source>After cue, s</source>
        <translation>Nach Signal, s</translation>
    </message>
    <message>
        <source>Response time from the first contact with a surface in this attempt, in seconds; it includes the whole exploration.</source>
        <translation>Reaktionszeit ab dem ersten Kontakt mit einer Oberfläche in diesem Versuch, in Sekunden; die gesamte Exploration ist darin enthalten.</translation>
    </message>
    <message>
        <source>Response time from the cue, when the question was first asked, in seconds; it includes surfaces that were felt again before the response.</source>
        <translation>Reaktionszeit ab dem Signal, mit dem die Frage zum ersten Mal gestellt wurde, in Sekunden; Oberflächen, die vor der Antwort noch einmal gefühlt wurden, sind darin enthalten.</translation>
    </message>
    <message>
        <source>answered %1 after the first contact</source>
        <translation>beantwortet %1 nach dem ersten Kontakt</translation>
    </message>
    <message>
        <source>Practice: not included in analyses</source>
        <translation>Übung: nicht in die Auswertungen einbezogen</translation>
    </message>
    <message>
        <source>Anchor: not included in analyses</source>
        <translation>Anker: nicht in die Auswertungen einbezogen</translation>
    </message>
    <message>
        <source>Not counted: no response</source>
        <translation>Nicht gezählt: keine Antwort</translation>
    </message>
    <message>
        <source>Counted in the analyses of pilot sessions</source>
        <translation>In den Auswertungen der Pilotsitzungen gezählt</translation>
    </message>
    <message>
        <source>invalidated, repeated</source>
        <translation>für ungültig erklärt, wiederholt</translation>
    </message>
    <message>
        <source>Practice repeated before the session was resumed: not included in analyses</source>
        <translation>Vor der Fortsetzung der Sitzung wiederholte Übung: nicht in die Auswertungen einbezogen</translation>
    </message>
    <message>
        <source>Catch trial: not included in thresholds</source>
        <translation>Kontrolldurchgang: nicht in die Schwellen einbezogen</translation>
    </message>
</context>
<context>
    <name>CellWords</name>
    <message>
        <source>Other or not reported</source>
        <translation>Andere oder keine Angabe</translation>
    </message>
    <message>
        <source>d′</source>
        <translation>d′</translation>
    </message>
    <message>
        <source>Cohen’s κ</source>
        <translation>Cohens κ</translation>
    </message>
    <message>
        <source>information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>women and men</source>
        <translation>Frauen und Männer</translation>
    </message>
    <message>
        <source>pairs with the target</source>
        <translation>Paare mit dem Ziel</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>bit</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>women, men</source>
        <translation>Frauen, Männer</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>spacing by condition</source>
        <translation>Abstand × Bedingung</translation>
    </message>
    <message>
        <source>peaks</source>
        <translation>Maxima</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>the parabola opens upwards</source>
        <translation>die Parabel ist nach oben geöffnet</translation>
    </message>
    <message>
        <source>outside the range of the tested spacings</source>
        <translation>außerhalb des Bereichs der geprüften Abstände</translation>
    </message>
    <message>
        <source>too few participants for a conclusion</source>
        <translation>zu wenige Versuchspersonen für eine Aussage</translation>
    </message>
    <message>
        <source>not every model is presented in every trial</source>
        <translation>nicht jedes Modell wird in jedem Durchgang dargeboten</translation>
    </message>
    <message>
        <source>cannot be tested with one participant</source>
        <translation>lässt sich mit nur einer Versuchsperson nicht prüfen</translation>
    </message>
    <message>
        <source>no significant interior maximum</source>
        <translation>kein signifikantes inneres Maximum</translation>
    </message>
    <message>
        <source>at least one condition has no interior maximum</source>
        <translation>mindestens eine Bedingung hat kein inneres Maximum</translation>
    </message>
    <message>
        <source>two models were never presented in the same trial</source>
        <translation>in keinem Durchgang wurden zwei Modelle dargeboten</translation>
    </message>
    <message>
        <source>no responses to test</source>
        <translation>keine zu prüfenden Antworten</translation>
    </message>
    <message>
        <source>the protocol declares no target, or there is only one texture</source>
        <translation>das Protokoll legt kein Ziel fest, oder es gibt nur eine Textur</translation>
    </message>
    <message>
        <source>fewer than two conditions have a peak</source>
        <translation>weniger als zwei Bedingungen haben ein Maximum</translation>
    </message>
    <message>
        <source>there is only one condition</source>
        <translation>es gibt nur eine Bedingung</translation>
    </message>
    <message>
        <source>only one item was rated on this scale</source>
        <translation>auf dieser Skala wurde nur ein Item beurteilt</translation>
    </message>
    <message>
        <source>the participants do not include both women and men</source>
        <translation>unter den Versuchspersonen sind keine Frauen oder keine Männer</translation>
    </message>
    <message>
        <source>the pictures differ between trials</source>
        <translation>die Bilder unterscheiden sich zwischen den Durchgängen</translation>
    </message>
    <message>
        <source>no participant ever chose the target</source>
        <translation>keine Versuchsperson hat je das Ziel gewählt</translation>
    </message>
    <message>
        <source>the target was never presented with another model</source>
        <translation>das Ziel wurde nie mit einem anderen Modell dargeboten</translation>
    </message>
    <message>
        <source>the participants have not judged every texture equally often</source>
        <translation>die Versuchspersonen haben nicht jede Textur gleich häufig beurteilt</translation>
    </message>
    <message>
        <source>the number of models differs between trials</source>
        <translation>die Anzahl der Modelle unterscheidet sich zwischen den Durchgängen</translation>
    </message>
    <message>
        <source>%1, exact</source>
        <translation>%1, exakt</translation>
    </message>
    <message>
        <source>%1, %2 permutations drawn at random</source>
        <translation>%1, %2 zufällig gezogene Permutationen</translation>
    </message>
    <message>
        <source>confirmatory</source>
        <translation>konfirmatorisch</translation>
    </message>
    <message>
        <source>exploratory</source>
        <translation>explorativ</translation>
    </message>
    <message>
        <source>proportion correct, mean over the textures</source>
        <translation>Anteil richtiger Antworten, Mittelwert über die Texturen</translation>
    </message>
    <message>
        <source>correctly matched items expected under guessing</source>
        <translation>beim Raten erwartete richtige Zuordnungen</translation>
    </message>
    <message>
        <source>stimulus entropy H(S)</source>
        <translation>Reizentropie H(S)</translation>
    </message>
    <message>
        <source>equal-error (Fano) estimate of the transmitted information</source>
        <translation>Schätzung der übertragenen Information bei gleich häufigen Fehlern (Fano)</translation>
    </message>
    <message>
        <source>transmitted information, jackknife</source>
        <translation>übertragene Information, Jackknife</translation>
    </message>
    <message>
        <source>transmitted information, bias-corrected (Miller 1955)</source>
        <translation>übertragene Information, bias-korrigiert (Miller 1955)</translation>
    </message>
    <message>
        <source>transmitted information, bias-corrected (Miller–Madow)</source>
        <translation>übertragene Information, bias-korrigiert (Miller-Madow)</translation>
    </message>
    <message>
        <source>transmitted information, plug-in</source>
        <translation>übertragene Information, unkorrigiert</translation>
    </message>
    <message>
        <source>Mallows’ θ (0 under guessing)</source>
        <translation>Mallows’ θ (0 beim Raten)</translation>
    </message>
    <message>
        <source>correctly matched items</source>
        <translation>richtige Zuordnungen</translation>
    </message>
    <message>
        <source>correctly matched items per trial</source>
        <translation>richtige Zuordnungen je Durchgang</translation>
    </message>
    <message>
        <source>proportion correct, “cannot tell” left out</source>
        <translation>Anteil richtiger Antworten ohne „kann es nicht sagen“</translation>
    </message>
    <message>
        <source>z of the correctly matched items</source>
        <translation>z der richtigen Zuordnungen</translation>
    </message>
    <message>
        <source>matched items</source>
        <translation>Zuordnungen</translation>
    </message>
    <message>
        <source>proportion correct</source>
        <translation>Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>all items correct</source>
        <translation>alle Zuordnungen richtig</translation>
    </message>
    <message>
        <source>responses</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>−∞</source>
        <translation>−∞</translation>
    </message>
    <message>
        <source>∞</source>
        <translation>∞</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>kann es nicht sagen</translation>
    </message>
    <message>
        <source>all trials</source>
        <translation>alle Durchgänge</translation>
    </message>
    <message>
        <source>repetition</source>
        <translation>Wiederholung</translation>
    </message>
    <message>
        <source>spacing (m)</source>
        <translation>Abstand (m)</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>proportion correct; change: second − first half</source>
        <translation>Anteil richtiger Antworten; Änderung: zweite − erste Hälfte</translation>
    </message>
    <message>
        <source>response time; change: ratio per 10 trials</source>
        <translation>Reaktionszeit; Änderung: Verhältnis je 10 Durchgänge</translation>
    </message>
    <message>
        <source>response time, s; change: ratio of the second to the first half</source>
        <translation>Reaktionszeit, s; Änderung: Verhältnis der zweiten zur ersten Hälfte</translation>
    </message>
    <message>
        <source>response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>participant</source>
        <translation>Versuchsperson</translation>
    </message>
    <message>
        <source>all stimuli or all responses are the same</source>
        <translation>alle Reize oder alle Antworten sind gleich</translation>
    </message>
    <message>
        <source>proportion of correctly matched items; change: second − first half</source>
        <translation>Anteil richtiger Zuordnungen; Änderung: zweite − erste Hälfte</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>the participants are not in two groups of the protocol</source>
        <translation>die Versuchspersonen gehören nicht zu zwei Gruppen des Protokolls</translation>
    </message>
    <message>
        <source>pairs of items</source>
        <translation>Paare von Items</translation>
    </message>
    <message>
        <source>ratings of the items</source>
        <translation>Urteile über die Items</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>loading of the scale</source>
        <translation>Ladung der Skala</translation>
    </message>
    <message>
        <source>score of the item</source>
        <translation>Komponentenwert des Items</translation>
    </message>
    <message>
        <source>equal items</source>
        <translation>gleiche Items</translation>
    </message>
    <message>
        <source>goodness of fit</source>
        <translation>Anpassungsgüte</translation>
    </message>
    <message>
        <source>ties, ln ν</source>
        <translation>Gleichstände, ln ν</translation>
    </message>
    <message>
        <source>order effect, log odds</source>
        <translation>Reihenfolgeeffekt, logarithmierte Odds</translation>
    </message>
    <message>
        <source>all comparisons of the pair were ties</source>
        <translation>alle Vergleiche des Paars ergaben Gleichstand</translation>
    </message>
    <message>
        <source>fewer than two participants compared every pair equally often</source>
        <translation>weniger als zwei Versuchspersonen haben jedes Paar gleich häufig verglichen</translation>
    </message>
    <message>
        <source>accompanying scales</source>
        <translation>begleitende Skalen</translation>
    </message>
    <message>
        <source>chosen item</source>
        <translation>gewähltes Item</translation>
    </message>
    <message>
        <source>correctness of the response</source>
        <translation>Richtigkeit der Antwort</translation>
    </message>
    <message>
        <source>difference, correct − incorrect</source>
        <translation>Differenz, richtig − falsch</translation>
    </message>
    <message>
        <source>presented item</source>
        <translation>dargebotenes Item</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>incorrect</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>tie</source>
        <translation>Gleichstand</translation>
    </message>
    <message>
        <source>no scale accompanies a question with correct responses</source>
        <translation>keine Skala begleitet eine Frage mit richtigen Antworten</translation>
    </message>
    <message>
        <source>there are fewer than two participants, or their differences are equal</source>
        <translation>es sind weniger als zwei Versuchspersonen, oder ihre Differenzen sind gleich</translation>
    </message>
    <message>
        <source>no participant has both correct and incorrect responses</source>
        <translation>keine Versuchsperson hat sowohl richtige als auch falsche Antworten</translation>
    </message>
    <message>
        <source>conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>point of subjective equality</source>
        <translation>Punkt der subjektiven Gleichheit</translation>
    </message>
    <message>
        <source>no response is correct</source>
        <translation>keine Antwort ist richtig</translation>
    </message>
    <message>
        <source>below the presented levels</source>
        <translation>unterhalb der dargebotenen Stufen</translation>
    </message>
    <message>
        <source>no responses</source>
        <translation>keine Antworten</translation>
    </message>
    <message>
        <source>responses are correct or incorrect, so that there is no point of subjective equality</source>
        <translation>Antworten sind richtig oder falsch, sodass es keinen Punkt der subjektiven Gleichheit gibt</translation>
    </message>
    <message>
        <source>no participant has a difference that is not zero</source>
        <translation>keine Versuchsperson hat eine Differenz, die nicht null ist</translation>
    </message>
    <message>
        <source>only one participant has a difference that is not zero</source>
        <translation>nur eine Versuchsperson hat eine Differenz, die nicht null ist</translation>
    </message>
    <message>
        <source>too few thresholds could be estimated</source>
        <translation>zu wenige Schwellen konnten geschätzt werden</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>responses do not depend on the level as expected</source>
        <translation>die Antworten hängen nicht wie erwartet von der Stufe ab</translation>
    </message>
    <message>
        <source>only one level was presented</source>
        <translation>nur eine Stufe wurde dargeboten</translation>
    </message>
    <message>
        <source>too few participants felt the comparison in both positions</source>
        <translation>zu wenige Versuchspersonen fühlten den Vergleichsreiz an beiden Positionen</translation>
    </message>
    <message>
        <source>outside the presented levels</source>
        <translation>außerhalb der dargebotenen Stufen</translation>
    </message>
    <message>
        <source>only one level has both responses</source>
        <translation>nur auf einer Stufe kommen beide Antworten vor</translation>
    </message>
    <message>
        <source>no level has both responses</source>
        <translation>auf keiner Stufe kommen beide Antworten vor</translation>
    </message>
    <message>
        <source>steeper than the presented levels can resolve</source>
        <translation>steiler, als die dargebotenen Stufen auflösen</translation>
    </message>
    <message>
        <source>just-noticeable difference (JND)</source>
        <translation>Unterschiedsschwelle (JND)</translation>
    </message>
    <message>
        <source>JND at d′ = 1</source>
        <translation>JND bei d′ = 1</translation>
    </message>
    <message>
        <source>JND, posterior mean</source>
        <translation>JND, A-posteriori-Mittel</translation>
    </message>
    <message>
        <source>point of subjective equality (PSE)</source>
        <translation>Punkt der subjektiven Gleichheit (PSE)</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>above the presented levels</source>
        <translation>oberhalb der dargebotenen Stufen</translation>
    </message>
    <message>
        <source>at an end of the prior</source>
        <translation>an einem Ende der A-priori-Verteilung</translation>
    </message>
    <message>
        <source>no participant has trials in every condition, and the test compares conditions within participants</source>
        <translation>keine Versuchsperson hat Durchgänge in allen Bedingungen, und der Test vergleicht Bedingungen innerhalb der Versuchspersonen</translation>
    </message>
    <message>
        <source>contact time, s</source>
        <translation>Kontaktdauer, s</translation>
    </message>
    <message>
        <source>mean normal force, N</source>
        <translation>mittlere Normalkraft, N</translation>
    </message>
    <message>
        <source>SD of the normal force, N</source>
        <translation>SD der Normalkraft, N</translation>
    </message>
    <message>
        <source>path in contact, m</source>
        <translation>Weg im Kontakt, m</translation>
    </message>
    <message>
        <source>response time, s</source>
        <translation>Reaktionszeit, s</translation>
    </message>
    <message>
        <source>mean speed, m/s</source>
        <translation>mittlere Geschwindigkeit, m/s</translation>
    </message>
    <message>
        <source>SD of the speed, m/s</source>
        <translation>SD der Geschwindigkeit, m/s</translation>
    </message>
    <message>
        <source>stroke length, m</source>
        <translation>Strichlänge, m</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>visits</source>
        <translation>Besuche</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>block position</source>
        <translation>Position des Blocks</translation>
    </message>
    <message>
        <source>session number</source>
        <translation>Nummer der Sitzung</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>trial, per 10</source>
        <translation>Durchgang, je 10</translation>
    </message>
    <message>
        <source>cannot be distinguished from the effects above</source>
        <translation>von den Effekten darüber nicht zu unterscheiden</translation>
    </message>
    <message>
        <source>the variance between participants is estimated as 0</source>
        <translation>die Varianz zwischen den Versuchspersonen wird auf 0 geschätzt</translation>
    </message>
    <message>
        <source>there is no error variance</source>
        <translation>es gibt keine Fehlervarianz</translation>
    </message>
    <message>
        <source>too few participants</source>
        <translation>zu wenige Versuchspersonen</translation>
    </message>
    <message>
        <source>too few measurements</source>
        <translation>zu wenige Messungen</translation>
    </message>
    <message>
        <source>the slope is at a limit of the fit</source>
        <translation>die Steigung liegt an einer Grenze der Anpassung</translation>
    </message>
    <message>
        <source>position of the comparison</source>
        <translation>Position des Vergleichsreizes</translation>
    </message>
    <message>
        <source>comparison presented first</source>
        <translation>Vergleichsreiz zuerst dargeboten</translation>
    </message>
    <message>
        <source>difference of the normal forces</source>
        <translation>Differenz der Normalkräfte</translation>
    </message>
    <message>
        <source>difference of the levels</source>
        <translation>Differenz der Stufen</translation>
    </message>
    <message>
        <source>difference of the speeds</source>
        <translation>Differenz der Geschwindigkeiten</translation>
    </message>
    <message>
        <source>no maximum of the likelihood was found</source>
        <translation>es wurde kein Maximum der Likelihood gefunden</translation>
    </message>
    <message>
        <source>the effects predict every choice, so that an effect is infinite</source>
        <translation>die Effekte sagen jede Wahl vorher, sodass ein Effekt unendlich ist</translation>
    </message>
    <message>
        <source>every response is the same</source>
        <translation>alle Antworten sind gleich</translation>
    </message>
    <message>
        <source>no response is a choice between two surfaces, so that there is no order effect</source>
        <translation>keine Antwort ist die Wahl zwischen zwei Oberflächen, sodass es keinen Reihenfolgeeffekt gibt</translation>
    </message>
    <message>
        <source>force in waves of %1 to %2 mm, RMS relative to the normal force</source>
        <translation>Kraft in Wellen von %1 bis %2 mm, Effektivwert bezogen auf die Normalkraft</translation>
    </message>
    <message>
        <source>RMS of the texture force, N</source>
        <translation>Effektivwert der Texturkraft, N</translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>different and identical surfaces</source>
        <translation>verschiedene und gleiche Oberflächen</translation>
    </message>
    <message>
        <source>measured properties</source>
        <translation>gemessene Eigenschaften</translation>
    </message>
    <message>
        <source>items</source>
        <translation>Items</translation>
    </message>
    <message>
        <source>item</source>
        <translation>Item</translation>
    </message>
    <message>
        <source>the rated pairs do not connect all items</source>
        <translation>die beurteilten Paare verbinden nicht alle Items</translation>
    </message>
    <message>
        <source>all pairs were rated equally dissimilar</source>
        <translation>alle Paare wurden als gleich unähnlich beurteilt</translation>
    </message>
    <message>
        <source>too few surfaces for this number of dimensions, in which many permuted ratings fit perfectly</source>
        <translation>zu wenige Oberflächen für diese Zahl der Dimensionen, in denen viele permutierte Urteile vollkommen passen</translation>
    </message>
    <message>
        <source>the ratings do not vary</source>
        <translation>die Urteile unterscheiden sich nicht</translation>
    </message>
    <message>
        <source>no identical pairs were presented</source>
        <translation>es wurden keine gleichen Paare dargeboten</translation>
    </message>
    <message>
        <source>there is no configuration, or no property was measured for every item</source>
        <translation>es gibt keine Konfiguration, oder keine Eigenschaft wurde für jedes Item gemessen</translation>
    </message>
    <message>
        <source>exponent of the power function</source>
        <translation>Exponent der Potenzfunktion</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>Reiz</translation>
    </message>
    <message>
        <source>stimulus by condition</source>
        <translation>Reiz nach Bedingung</translation>
    </message>
    <message>
        <source>there are fewer than three values of the predictor, or the predictor was not measured for every stimulus</source>
        <translation>es gibt weniger als drei Werte des Prädiktors, oder er wurde nicht für jeden Reiz gemessen</translation>
    </message>
    <message>
        <source>easy</source>
        <translation>leicht</translation>
    </message>
    <message>
        <source>identical pair</source>
        <translation>gleiches Paar</translation>
    </message>
    <message>
        <source>no signal</source>
        <translation>kein Signal</translation>
    </message>
    <message>
        <source>no CI, because the responses hardly determine the threshold</source>
        <translation>kein KI, weil die Antworten die Schwelle kaum bestimmen</translation>
    </message>
    <message>
        <source>all participants</source>
        <translation>alle Versuchspersonen</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>analysis of variance of the ratings</source>
        <translation>Varianzanalyse der Einstufungen</translation>
    </message>
    <message>
        <source>each repetition presents other textures than the others</source>
        <translation>jede Wiederholung zeigt andere Texturen als die übrigen</translation>
    </message>
    <message>
        <source>nearly all responses are correct or of the target</source>
        <translation>fast alle Antworten sind richtig oder gelten dem Ziel</translation>
    </message>
    <message>
        <source>hardly any response is correct or of the target</source>
        <translation>kaum eine Antwort ist richtig oder gilt dem Ziel</translation>
    </message>
    <message>
        <source>no mean: neither an upper nor a lower bound without the others</source>
        <translation>kein Mittelwert: ohne die übrigen weder eine obere noch eine untere Schranke</translation>
    </message>
    <message>
        <source>lower bound: the others are above the levels</source>
        <translation>untere Schranke: die übrigen liegen über den Stufen</translation>
    </message>
    <message>
        <source>upper bound: the others are below the levels</source>
        <translation>obere Schranke: die übrigen liegen unter den Stufen</translation>
    </message>
    <message>
        <source>fewer levels were presented than the function has parameters</source>
        <translation>es wurden weniger Stufen dargeboten, als die Funktion Parameter hat</translation>
    </message>
    <message>
        <source>proportion correct; change: last − first</source>
        <translation>Anteil richtig; Veränderung: letzte − erste</translation>
    </message>
    <message>
        <source>estimate; change: last/first</source>
        <translation>Schätzung; Veränderung: letzte/erste</translation>
    </message>
    <message>
        <source>rating; change: last − first</source>
        <translation>Urteil; Veränderung: letzte − erste</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>too few items</source>
        <translation>zu wenige Items</translation>
    </message>
    <message>
        <source>an item has no response</source>
        <translation>ein Item hat keine Antwort</translation>
    </message>
    <message>
        <source>too few raters</source>
        <translation>zu wenige Beurteiler</translation>
    </message>
    <message>
        <source>too few scales</source>
        <translation>zu wenige Skalen</translation>
    </message>
    <message>
        <source>too few surfaces</source>
        <translation>zu wenige Oberflächen</translation>
    </message>
    <message>
        <source>too few targets</source>
        <translation>zu wenige beurteilte Objekte</translation>
    </message>
    <message>
        <source>too few textures</source>
        <translation>zu wenige Texturen</translation>
    </message>
    <message>
        <source>profiles of the groups</source>
        <translation>Profile der Gruppen</translation>
    </message>
    <message>
        <source>there is no estimate of any participant of one of the groups</source>
        <translation>von keiner Versuchsperson einer der Gruppen gibt es einen Schätzwert</translation>
    </message>
    <message>
        <source>two groups have fewer than two items in common</source>
        <translation>zwei Gruppen haben weniger als zwei Objekte gemeinsam</translation>
    </message>
    <message>
        <source>the groups share no condition</source>
        <translation>die Gruppen haben keine Bedingung gemeinsam</translation>
    </message>
    <message>
        <source>each of the groups has one participant</source>
        <translation>jede der Gruppen hat eine Versuchsperson</translation>
    </message>
    <message>
        <source>no block of the assignment has participants of both groups</source>
        <translation>in keinem Block der Zuteilung sind Versuchspersonen beider Gruppen</translation>
    </message>
    <message>
        <source>choices of the items</source>
        <translation>Wahlen der Items</translation>
    </message>
</context>
<context>
    <name>Columns</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>95 % CI</source>
        <translation>95-%-KI</translation>
    </message>
</context>
<context>
    <name>CommandWords</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Command…</source>
        <translation>Befehl…</translation>
    </message>
    <message>
        <source>The same on the command line</source>
        <translation>Dasselbe in der Befehlszeile</translation>
    </message>
</context>
<context>
    <name>DeviceSurvey</name>
    <message>
        <source>The udev rules file %1 is not installed: only root can open USB devices. Copy %2 into /etc/udev/rules.d, then unplug the device and plug it in again (docs/devices.md).</source>
        <translation>Die udev-Regeldatei %1 ist nicht installiert: Nur root kann USB-Geräte öffnen. %2 nach /etc/udev/rules.d kopieren, das Gerät abziehen und wieder anstecken (docs/devices.md).</translation>
    </message>
</context>
<context>
    <name>DeviceTest</name>
    <message>
        <source>the servo loop set the force to zero (%1)</source>
        <translation>die Servoschleife setzte die Kraft auf null (%1)</translation>
    </message>
    <message>
        <source>the handle moved away by more than %1 mm, and the force was switched off</source>
        <translation>der Griff bewegte sich um mehr als %1 mm weg, und die Kraft wurde abgeschaltet</translation>
    </message>
    <message>
        <source>along %1 %2</source>
        <translation>entlang %1 %2</translation>
    </message>
    <message>
        <source>Not measured: %1. If this value is needed, fix the cause and measure the device again.</source>
        <translation>Nicht gemessen: %1. Wenn dieser Wert gebraucht wird, die Ursache beheben und das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>Measured on a simulated device: the value characterises this computer.</source>
        <translation>An einem simulierten Gerät gemessen: Der Wert kennzeichnet diesen Rechner.</translation>
    </message>
    <message>
        <source>No surface was presented.</source>
        <translation>Es wurde keine Oberfläche dargeboten.</translation>
    </message>
    <message>
        <source>The servo loop did not run: %1. Fix the cause, then measure the device again.</source>
        <translation>Die Servoschleife lief nicht: %1. Die Ursache beheben, dann das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>Largest force sent without a surface.</source>
        <translation>Größte ohne Oberfläche gesendete Kraft.</translation>
    </message>
    <message>
        <source>Standard deviation of the positions of the handle at rest.</source>
        <translation>Standardabweichung der Positionen des ruhenden Griffs.</translation>
    </message>
    <message>
        <source>there were too few readings</source>
        <translation>es gab zu wenige Messwerte</translation>
    </message>
    <message>
        <source>It has no motors.</source>
        <translation>Es hat keine Motoren.</translation>
    </message>
    <message>
        <source>When %1 N was requested at a limit of %2 N, at most %3 N was sent.</source>
        <translation>Als bei einer Grenze von %2 N eine Kraft von %1 N angefordert wurde, wurden höchstens %3 N gesendet.</translation>
    </message>
    <message>
        <source>After a stop under force, exactly 0 N was sent from the next tick on.</source>
        <translation>Nach einem Halt bei wirkender Kraft wurden vom nächsten Takt an genau 0 N gesendet.</translation>
    </message>
    <message>
        <source>When a force that is not finite was requested, exactly 0 N was sent in the same tick.</source>
        <translation>Als eine Kraft angefordert wurde, die keine endliche Zahl ist, wurden im selben Takt genau 0 N gesendet.</translation>
    </message>
    <message>
        <source>Without a heartbeat from the program, the force faded to 0 N (timeout in a session: %1 s).</source>
        <translation>Ohne Lebenszeichen des Programms ging die Kraft auf 0 N zurück (Wartezeit in einer Sitzung: %1 s).</translation>
    </message>
    <message>
        <source>This is required, and it did not happen: %1</source>
        <translation>Das ist erforderlich und trat nicht ein: %1</translation>
    </message>
    <message>
        <source>the handle did not follow a force of %1 N</source>
        <translation>der Griff folgte einer Kraft von %1 N nicht</translation>
    </message>
    <message>
        <source>the handle did not move</source>
        <translation>der Griff bewegte sich nicht</translation>
    </message>
    <message>
        <source>the sweeps were inconclusive</source>
        <translation>die langsamen Bewegungen waren nicht aussagekräftig</translation>
    </message>
    <message>
        <source>a push of %1 N did not move the handle</source>
        <translation>ein Stoß von %1 N bewegte den Griff nicht</translation>
    </message>
    <message>
        <source>Time from a force step to the measured motion.</source>
        <translation>Zeit von einem Kraftsprung bis zur gemessenen Bewegung.</translation>
    </message>
    <message>
        <source>Mass of the handle and the parts that move with it, from the acceleration after a force step.</source>
        <translation>Masse des Griffs und der mitbewegten Teile, bestimmt aus der Beschleunigung nach einem Kraftsprung.</translation>
    </message>
    <message>
        <source>Coulomb friction, from slow back-and-forth sweeps at two speeds.</source>
        <translation>Coulombsche Reibung, bestimmt aus langsamen Hin- und Herbewegungen mit zwei Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Increase of the resistance to motion with speed.</source>
        <translation>Zunahme des Bewegungswiderstands mit der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The position resolution that corresponds to the errors measured in a slow sweep.</source>
        <translation>Die Positionsauflösung, die den bei einer langsamen Bewegung gemessenen Fehlern entspricht.</translation>
    </message>
    <message>
        <source>The lowest frequency at which the handle responds twice as strongly as its mass alone.</source>
        <translation>Die niedrigste Frequenz, bei der der Griff doppelt so stark reagiert wie seine Masse allein.</translation>
    </message>
    <message>
        <source>there is no resonance between %1 and %2 Hz</source>
        <translation>von %1 bis %2 Hz gibt es keine Resonanz</translation>
    </message>
    <message>
        <source>The stiffest spring, up to 8000 N/m, on which the handle came to rest after an impulse.</source>
        <translation>Die steifste Feder, bis 8000 N/m, auf der der Griff nach einem Impuls zur Ruhe kam.</translation>
    </message>
    <message>
        <source>even a spring of 250 N/m made the handle oscillate</source>
        <translation>schon eine Feder von 250 N/m brachte den Griff zum Schwingen</translation>
    </message>
    <message>
        <source>The weakest push, in steps of a factor of √2, that moved the handle from rest.</source>
        <translation>Der schwächste Stoß, in Schritten um den Faktor √2, der den ruhenden Griff bewegte.</translation>
    </message>
    <message>
        <source>no push up to %1 N moved the handle</source>
        <translation>kein Stoß bis %1 N bewegte den Griff</translation>
    </message>
    <message>
        <source>The handle was not moved along the borders of its workspace; measure the device again, and move the handle along them.</source>
        <translation>Der Griff wurde nicht an den Grenzen seines Arbeitsraums entlanggeführt; das Gerät erneut messen und den Griff an ihnen entlangführen.</translation>
    </message>
    <message>
        <source>There were no readings of the position; check the cable, and measure the device again.</source>
        <translation>Es gab keine Messwerte der Position; das Kabel prüfen und das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>The smallest fraction of the declared workspace that the handle reached along an axis.</source>
        <translation>Der kleinste Anteil des angegebenen Arbeitsraums, den der Griff entlang einer Achse erreichte.</translation>
    </message>
    <message>
        <source>A session of %1 is running. Measure the device when the session has ended.</source>
        <translation>Eine Sitzung von %1 läuft. Das Gerät messen, sobald die Sitzung beendet ist.</translation>
    </message>
    <message>
        <source>A device is being measured for this study. Stop the measurement or wait until it has ended, then start the session.</source>
        <translation>Für diese Studie wird gerade ein Gerät gemessen. Die Messung stoppen oder ihr Ende abwarten, dann die Sitzung starten.</translation>
    </message>
    <message>
        <source>Unknown for %1, which the simulated device models; measure the real device.</source>
        <translation>Unbekannt für %1, das vom simulierten Gerät nachgebildet wird; das echte Gerät messen.</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>continuous force</source>
        <translation>Dauerkraft</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Taktrate</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>position resolution</source>
        <translation>Positionsauflösung</translation>
    </message>
    <message>
        <source>position noise</source>
        <translation>Positionsrauschen</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>moving mass</source>
        <translation>bewegte Masse</translation>
    </message>
    <message>
        <source>resonance</source>
        <translation>Resonanz</translation>
    </message>
    <message>
        <source>stiffest spring</source>
        <translation>steifste Feder</translation>
    </message>
    <message>
        <source>force resolution</source>
        <translation>Kraftauflösung</translation>
    </message>
    <message>
        <source>Simulated model of %1; known: %2; unknown: %3.</source>
        <translation>Simuliertes Modell von %1; bekannt: %2; unbekannt: %3.</translation>
    </message>
    <message>
        <source>The device met every limit.</source>
        <translation>Das Gerät hielt jeden Grenzwert ein.</translation>
    </message>
    <message>
        <source>The device did not meet every limit: %1. Repair it and measure it again, or choose another device.</source>
        <translation>Das Gerät hielt nicht jeden Grenzwert ein: %1. Es instand setzen und erneut messen oder ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>Not measured, although a limit applies: %1. Measure the device again.</source>
        <translation>Nicht gemessen, obwohl ein Grenzwert gilt: %1. Das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>the connection to the device was lost during the measurement: %1 Fix the problem, then measure the device again.</source>
        <translation>die Verbindung zum Gerät ging während der Messung verloren: %1 Das Problem beheben, dann das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>the connection to the device was lost during the measurement: the thread of the manufacturer&apos;s driver made no call for %1 ms; it hangs or had to wait. Close other programs that keep this computer busy, check the cable of the device, and measure the device again.</source>
        <translation>die Verbindung zum Gerät ging während der Messung verloren: Der Aufruf aus dem Thread des Herstellertreibers blieb %1 ms lang aus; der Thread hängt oder musste warten. Andere Programme schließen, die diesen Rechner belasten, das Kabel prüfen und das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>setting the force to zero</source>
        <translation>dem Nullsetzen der Kraft</translation>
    </message>
    <message>
        <source>sending the force</source>
        <translation>dem Senden der Kraft</translation>
    </message>
    <message>
        <source>reading the position</source>
        <translation>dem Lesen der Position</translation>
    </message>
    <message>
        <source>the device %1 does not respond: its driver has not returned from %2 for more than a second. Switch the device off, end this program, check the cables of the device, then measure it again.</source>
        <translation>das Gerät %1 antwortet nicht: Sein Treiber ist seit mehr als einer Sekunde nicht von %2 zurückgekehrt. Das Gerät ausschalten, dieses Programm beenden, die Kabel des Geräts prüfen, dann erneut messen.</translation>
    </message>
    <message>
        <source>the connection to the device was lost during the measurement: the device did not respond, and its driver reports no cause. Check its cable and its power supply, close other programs that keep this computer busy, and measure the device again.</source>
        <translation>die Verbindung zum Gerät ging während der Messung verloren: Das Gerät antwortete nicht, und sein Treiber meldet keine Ursache. Kabel und Stromversorgung prüfen, andere Programme schließen, die diesen Rechner belasten, und das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>The device met every limit that was measured.</source>
        <translation>Das Gerät hielt jeden geprüften Grenzwert ein.</translation>
    </message>
    <message>
        <source>No limit applied to the device.</source>
        <translation>Für das Gerät galt kein Grenzwert.</translation>
    </message>
    <message>
        <source>the handle of %1 will move by itself for one and a half to three minutes, by at most 3 cm, with a force of at most %2 N. Let it hang free in the middle of its workspace, keep hands and hair away, and make sure that it is not held.</source>
        <translation>der Griff von %1 wird sich anderthalb bis drei Minuten lang von selbst bewegen, um höchstens 3 cm, mit einer Kraft von höchstens %2 N. Den Griff frei in der Mitte seines Arbeitsraums hängen lassen, Hände und Haare fernhalten und sicherstellen, dass er nicht gehalten wird.</translation>
    </message>
    <message>
        <source>the handle kept swinging by %1 mm during the sweeps</source>
        <translation>der Griff schwang während der langsamen Bewegungen um %1 mm</translation>
    </message>
    <message>
        <source>the handle did not come to rest within %1 s before a push</source>
        <translation>der Griff kam vor einem Stoß innerhalb von %1 s nicht zur Ruhe</translation>
    </message>
</context>
<context>
    <name>DriftCheck</name>
    <message>
        <source>Tip at its reference: position (%1, %2, %3) mm, noise %4 mm, drift %5 mm in %6 s.</source>
        <translation>Spitze am Bezugspunkt: Position (%1; %2; %3) mm, Rauschen %4 mm, Drift %5 mm in %6 s.</translation>
    </message>
    <message>
        <source>Handle at rest: position (%1, %2, %3) mm, noise %4 mm, drift %5 mm in %6 s.</source>
        <translation>Griff in Ruhe: Position (%1; %2; %3) mm, Rauschen %4 mm, Drift %5 mm in %6 s.</translation>
    </message>
    <message>
        <source>Distance from the first check of the session: %1 mm.</source>
        <translation>Abstand von der ersten Prüfung der Sitzung: %1 mm.</translation>
    </message>
    <message>
        <source>Noise and drift are within the limit of this device, %1 mm.</source>
        <translation>Rauschen und Drift liegen innerhalb der Grenze dieses Geräts, %1 mm.</translation>
    </message>
    <message>
        <source>Noise or drift exceeds the limit of this device, %1 mm: check that the tip is held still at its reference, and the device, before you continue.</source>
        <translation>Rauschen oder Drift überschreitet die Grenze dieses Geräts, %1 mm: Prüfen Sie, dass die Spitze am Bezugspunkt ruhig gehalten wird, und das Gerät, bevor Sie fortfahren.</translation>
    </message>
    <message>
        <source>Noise or drift exceeds the limit of this device, %1 mm: check that nothing touches the handle, and the device, before you continue.</source>
        <translation>Rauschen oder Drift überschreitet die Grenze dieses Geräts, %1 mm: Prüfen Sie, dass nichts den Griff berührt, und das Gerät, bevor Sie fortfahren.</translation>
    </message>
</context>
<context>
    <name>DriverWords</name>
    <message>
        <source>“Set up…” on the Devices page</source>
        <translation>„Einrichten…“ auf der Seite „Geräte“</translation>
    </message>
    <message>
        <source>“Test this device…” on the Devices page</source>
        <translation>„Dieses Gerät testen…“ auf der Seite „Geräte“</translation>
    </message>
</context>
<context>
    <name>ExternalProgram</name>
    <message>
        <source>the file %1 cannot be read, and its checksum is stored with the session: %2; check the permissions of the file, or correct the external program and its arguments</source>
        <translation>die Datei %1 kann nicht gelesen werden, und ihre Prüfsumme wird mit der Sitzung gespeichert: %2; die Zugriffsrechte der Datei prüfen oder das externe Programm und seine Argumente korrigieren</translation>
    </message>
    <message>
        <source>the levels of the block &quot;%1&quot; come from an external program, and none is given; give it with --external PROGRAM, or choose it in the window</source>
        <translation>die Stufen des Blocks „%1“ kommen aus einem externen Programm, und es ist keines angegeben; das Programm mit --external PROGRAM angeben oder im Fenster wählen</translation>
    </message>
    <message>
        <source>the protocol &quot;%1&quot; takes no levels from an external program; leave out the program %2, or set the procedure of a block to &quot;external&quot;</source>
        <translation>das Protokoll „%1“ bezieht keine Stufen aus einem externen Programm; das Programm %2 weglassen oder das Verfahren eines Blocks auf „external“ setzen</translation>
    </message>
    <message>
        <source>the external program %1 does not exist or is not a file; give the path of the program itself</source>
        <translation>das externe Programm %1 existiert nicht oder ist keine Datei; den Pfad des Programms selbst angeben</translation>
    </message>
    <message>
        <source>the external program %1 cannot be executed; make it executable (chmod +x), and begin a script with the line #! and its interpreter</source>
        <translation>das externe Programm %1 kann nicht ausgeführt werden; es ausführbar machen (chmod +x) und ein Skript mit der Zeile #! und seinem Interpreter beginnen</translation>
    </message>
    <message>
        <source>it ended with status %1</source>
        <translation>es endete mit dem Status %1</translation>
    </message>
    <message>
        <source>signal %1 ended it</source>
        <translation>Signal %1 beendete es</translation>
    </message>
    <message>
        <source>it closed its standard output</source>
        <translation>es schloss seine Standardausgabe</translation>
    </message>
    <message>
        <source>the external program %1 cannot be started (%2); check that it is executable and, if it is a script, that its interpreter exists</source>
        <translation>das externe Programm %1 kann nicht gestartet werden (%2); prüfen, ob es ausführbar ist und, bei einem Skript, ob sein Interpreter existiert</translation>
    </message>
    <message>
        <source>the external program %1 wrote &quot;%2&quot; without being asked; it must write one line for each &quot;ask&quot;, and everything else to its standard error</source>
        <translation>das externe Programm %1 schrieb „%2“, ohne gefragt zu sein; es muss eine Zeile für jedes „ask“ schreiben und alles andere in seine Standardfehlerausgabe</translation>
    </message>
    <message>
        <source>the external program %1 wrote more than the one line that was asked for: &quot;%2&quot;; it must write one line for each &quot;ask&quot;, and everything else to its standard error</source>
        <translation>das externe Programm %1 schrieb mehr als die eine verlangte Zeile: „%2“; es muss eine Zeile für jedes „ask“ schreiben und alles andere in seine Standardfehlerausgabe</translation>
    </message>
    <message>
        <source>the external program %1 wrote %2 bytes without the end of a line, beginning with &quot;%3&quot;; it must write one line for each &quot;ask&quot;</source>
        <translation>das externe Programm %1 schrieb %2 Byte ohne Zeilenende, beginnend mit „%3“; es muss eine Zeile für jedes „ask“ schreiben</translation>
    </message>
    <message>
        <source>the external program %1 did not state the level: %2%3; what it wrote to its standard error is in %4</source>
        <translation>das externe Programm %1 hat die Stufe nicht angegeben: %2%3; seine Standardfehlerausgabe steht in %4</translation>
    </message>
    <message>
        <source>the external program %1 did not answer within %2 s; check that it writes a line and flushes it after each &quot;ask&quot;, or raise &quot;answer_within_s&quot; in the protocol</source>
        <translation>das externe Programm %1 hat nicht innerhalb von %2 s geantwortet; prüfen, ob es nach jedem „ask“ eine Zeile schreibt und den Ausgabepuffer leert, oder „answer_within_s“ im Protokoll erhöhen</translation>
    </message>
    <message>
        <source>the external program %1 stated the level %2, but the levels of the block lie between %3 and %4; correct the program, or extend the levels in the protocol</source>
        <translation>das externe Programm %1 gab die Stufe %2 an, aber die Stufen des Blocks liegen zwischen %3 und %4; das Programm korrigieren oder die Stufen im Protokoll erweitern</translation>
    </message>
    <message>
        <source>the external program %1 reports a problem: %2</source>
        <translation>das externe Programm %1 meldet ein Problem: %2</translation>
    </message>
    <message>
        <source>the external program %1 answered &quot;%2&quot;, which is neither a level nor the end of the track; it must write {&quot;level&quot;: NUMBER} or {&quot;end&quot;: true}</source>
        <translation>das externe Programm %1 antwortete „%2“, was weder eine Stufe noch das Ende der Spur ist; es muss {&quot;level&quot;: ZAHL} oder {&quot;end&quot;: true} schreiben</translation>
    </message>
    <message>
        <source>what the external program %1 writes to its standard error cannot be kept: %2; check the permissions and the free space of the study&apos;s folder</source>
        <translation>die Standardfehlerausgabe des externen Programms %1 kann nicht aufbewahrt werden: %2; die Zugriffsrechte und den freien Platz des Studienordners prüfen</translation>
    </message>
    <message>
        <source>the external program %1 did not state the level: %2, and it wrote nothing to its standard error; start it by hand to find the cause</source>
        <translation>das externe Programm %1 hat die Stufe nicht angegeben: %2, und es hat nichts auf seine Standardfehlerausgabe geschrieben; zum Finden der Ursache von Hand starten</translation>
    </message>
</context>
<context>
    <name>Figures</name>
    <message>
        <source>cannot tell</source>
        <translation>kann es nicht sagen</translation>
    </message>
    <message>
        <source>There are no responses and therefore no confusions; collect responses first.</source>
        <translation>Es gibt keine Antworten und daher keine Verwechslungen; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
    <message>
        <source>chance level</source>
        <translation>Zufallsniveau</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>women</source>
        <translation>Frauen</translation>
    </message>
    <message>
        <source>men</source>
        <translation>Männer</translation>
    </message>
    <message>
        <source>other or not reported</source>
        <translation>andere oder keine Angabe</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>all together</source>
        <translation>alle zusammen</translation>
    </message>
    <message>
        <source>mean of %1 participants</source>
        <translation>Mittelwert von %1 Versuchspersonen</translation>
    </message>
    <message>
        <source>Proportion of choices of each alternative</source>
        <translation>Anteil jeder Alternative an den Wahlen</translation>
    </message>
    <message>
        <source>Proportion of correct matches of each texture</source>
        <translation>Anteil richtiger Zuordnungen jeder Textur</translation>
    </message>
    <message>
        <source>Proportion correct for each stimulus</source>
        <translation>Anteil richtiger Antworten zu jedem Reiz</translation>
    </message>
    <message>
        <source>Textures matched to their pictures</source>
        <translation>Richtig zugeordnete Texturen</translation>
    </message>
    <message>
        <source>Textures recognised</source>
        <translation>Erkannte Texturen</translation>
    </message>
    <message>
        <source>No level has trials, so that there are no proportions correct; collect responses first.</source>
        <translation>Keine Stufe hat Durchgänge, daher gibt es keine Anteile richtiger Antworten; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>level, in the unit of the table</source>
        <translation>Stufe, in der Einheit der Tabelle</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Estimated roughness by spacing</source>
        <translation>Geschätzte Rauheit nach Abstand</translation>
    </message>
    <message>
        <source>%1 Curves: mean parabolas of the log estimates.</source>
        <translation>%1 Kurven: mittlere Parabeln der logarithmierten Schätzungen.</translation>
    </message>
    <message>
        <source>probe %1</source>
        <translation>Taster %1</translation>
    </message>
    <message>
        <source>There is no curve: %1.</source>
        <translation>Es gibt keine Kurve: %1.</translation>
    </message>
    <message>
        <source>There is no curve, because there are no estimates; collect estimates first.</source>
        <translation>Es gibt keine Kurve, weil es keine Schätzungen gibt; erst Schätzungen erheben.</translation>
    </message>
    <message>
        <source>spacing, in the unit of the table</source>
        <translation>Abstand, in der Einheit der Tabelle</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>roughness, normalised estimate</source>
        <translation>Rauheit, normierte Schätzung</translation>
    </message>
    <message>
        <source>There is no scale: %1.</source>
        <translation>Es gibt keine Skala: %1.</translation>
    </message>
    <message>
        <source>There is no scale, because there are no judgements; collect judgements first.</source>
        <translation>Es gibt keine Skala, weil es keine Urteile gibt; erst Urteile erheben.</translation>
    </message>
    <message>
        <source>first MDS dimension</source>
        <translation>erste MDS-Dimension</translation>
    </message>
    <message>
        <source>second dimension</source>
        <translation>zweite Dimension</translation>
    </message>
    <message>
        <source>Both groups: means of the participants</source>
        <translation>Beide Gruppen: Mittelwerte der Versuchspersonen</translation>
    </message>
    <message>
        <source>The difference between the groups</source>
        <translation>Der Unterschied zwischen den Gruppen</translation>
    </message>
    <message>
        <source>Fewer than two groups have responses, so that no comparison is possible; collect responses of both groups.</source>
        <translation>Weniger als zwei Gruppen haben Antworten, daher ist kein Vergleich möglich; Antworten beider Gruppen erheben.</translation>
    </message>
    <message>
        <source>%1 (n = %2)</source>
        <translation>%1 (n = %2)</translation>
    </message>
    <message>
        <source>means of the participants</source>
        <translation>Mittelwerte der Versuchspersonen</translation>
    </message>
    <message>
        <source>all responses together</source>
        <translation>alle Antworten zusammen</translation>
    </message>
    <message>
        <source>The difference of means could not be computed; add participants to both groups.</source>
        <translation>Die Differenz der Mittelwerte konnte nicht berechnet werden; in beiden Gruppen Versuchspersonen ergänzen.</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>kein Unterschied</translation>
    </message>
    <message>
        <source>Ratings by item</source>
        <translation>Urteile über jedes Item</translation>
    </message>
    <message>
        <source>Points are means over the participants who rated every item; error bars show their t-based %1 % CIs. The accompanying tests use only the ranks of the ratings.</source>
        <translation>Punkte sind Mittelwerte über die Versuchspersonen, die alle Items beurteilt haben; Fehlerbalken zeigen ihre t-basierten %1-%-KI. Die zugehörigen Tests verwenden nur die Ränge der Urteile.</translation>
    </message>
    <message>
        <source>No participant rated every item, so that there are no means; add the missing ratings.</source>
        <translation>Keine Versuchsperson hat alle Items beurteilt, daher gibt es keine Mittelwerte; die fehlenden Urteile ergänzen.</translation>
    </message>
    <message>
        <source>Means by condition</source>
        <translation>Mittelwerte je Bedingung</translation>
    </message>
    <message>
        <source>There are no means: %1.</source>
        <translation>Es gibt keine Mittelwerte: %1.</translation>
    </message>
    <message>
        <source>There are no means, because there are no measurements; collect measurements first.</source>
        <translation>Es gibt keine Mittelwerte, weil es keine Messwerte gibt; erst Messwerte erheben.</translation>
    </message>
    <message>
        <source>mean, in the unit of the table</source>
        <translation>Mittelwert, in der Einheit der Tabelle</translation>
    </message>
    <message>
        <source>exact binomial test, one-sided</source>
        <translation>exakter Binomialtest, einseitig</translation>
    </message>
    <message>
        <source>exact binomial test, two-sided</source>
        <translation>exakter Binomialtest, zweiseitig</translation>
    </message>
    <message>
        <source>Fisher&apos;s exact test</source>
        <translation>Fishers exakter Test</translation>
    </message>
    <message>
        <source>matching, some items known</source>
        <translation>Zuordnung, teilweise bekannt</translation>
    </message>
    <message>
        <source>matching, Mallows&apos; model</source>
        <translation>Zuordnung, Mallows’ Modell</translation>
    </message>
    <message>
        <source>paired t test</source>
        <translation>gepaarter t-Test</translation>
    </message>
    <message>
        <source>repeated-measures ANOVA</source>
        <translation>Varianzanalyse mit Messwiederholung</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>planned n</source>
        <translation>geplantes n</translation>
    </message>
    <message>
        <source>power: probability of detecting the effect</source>
        <translation>Teststärke: Wahrscheinlichkeit, den Effekt zu entdecken</translation>
    </message>
    <message>
        <source>80 %</source>
        <translation>80 %</translation>
    </message>
    <message>
        <source>%1 · %2 (n = %3)</source>
        <translation>%1 · %2 (n = %3)</translation>
    </message>
    <message>
        <source>Power of the planned tests</source>
        <translation>Teststärke der geplanten Tests</translation>
    </message>
    <message>
        <source>Points are powers at the planned sample sizes, each computed separately: between them, the power of exact tests of counts is not monotonic. The dashed line is the conventional power of 80 %.</source>
        <translation>Punkte sind Teststärken bei den geplanten Stichprobenumfängen, jede für sich berechnet: Dazwischen verläuft die Teststärke exakter Tests von Anzahlen nicht monoton. Die gestrichelte Linie ist die übliche Teststärke von 80 %.</translation>
    </message>
    <message>
        <source>No power was computed for any plan; add a plan to the table.</source>
        <translation>Für keinen Plan wurde eine Teststärke berechnet; der Tabelle einen Plan hinzufügen.</translation>
    </message>
    <message>
        <source>probe %1 mm</source>
        <translation>Taster %1 mm</translation>
    </message>
    <message>
        <source>force %1 N</source>
        <translation>Kraft %1 N</translation>
    </message>
    <message>
        <source>speed %1 mm/s</source>
        <translation>Geschwindigkeit %1 mm/s</translation>
    </message>
    <message>
        <source>Predicted roughness by probe diameter</source>
        <translation>Vorhergesagte Rauheit nach Durchmesser des Tasters</translation>
    </message>
    <message>
        <source>Predicted roughness by applied force</source>
        <translation>Vorhergesagte Rauheit nach Andruckkraft</translation>
    </message>
    <message>
        <source>Predicted roughness by exploratory speed</source>
        <translation>Vorhergesagte Rauheit nach Geschwindigkeit des Strichs</translation>
    </message>
    <message>
        <source>spatial frequency</source>
        <translation>Ortsfrequenz</translation>
    </message>
    <message>
        <source>maximum acceleration</source>
        <translation>größte Beschleunigung</translation>
    </message>
    <message>
        <source>There is no curve, because the tool was not moved; use a stroke with a length above 0.</source>
        <translation>Es gibt keine Kurve, weil das Werkzeug nicht bewegt wurde; einen Strich mit einer Länge über 0 verwenden.</translation>
    </message>
    <message>
        <source>one participant</source>
        <translation>eine Versuchsperson</translation>
    </message>
    <message>
        <source>position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 vor %2</translation>
    </message>
    <message>
        <source>RMS acceleration</source>
        <translation>Effektivwert der Beschleunigung</translation>
    </message>
    <message>
        <source>power from 5 to 50 Hz</source>
        <translation>Leistung von 5 bis 50 Hz</translation>
    </message>
    <message>
        <source>power from 50 to 500 Hz</source>
        <translation>Leistung von 50 bis 500 Hz</translation>
    </message>
    <message>
        <source>power relative to the threshold</source>
        <translation>Leistung relativ zur Schwelle</translation>
    </message>
    <message>
        <source>Filled symbols: strokes of the held tool. Small open symbols: strokes left out because of their status. Curves: parabolas fitted on logarithmic axes. Large open symbols: their peaks within the range, with 95 % CIs by Fieller&apos;s method.</source>
        <translation>Gefüllte Zeichen: Striche des gehaltenen Werkzeugs. Kleine offene Zeichen: Striche, die wegen ihres Status weggelassen sind. Kurven: auf logarithmischen Achsen angepasste Parabeln. Große offene Zeichen: ihre Maxima im Bereich, mit 95-%-Fieller-Intervallen der Anpassung.</translation>
    </message>
    <message>
        <source>%1 (no effect by construction)</source>
        <translation>%1 (konstruktionsbedingt ohne Effekt)</translation>
    </message>
    <message>
        <source>%1 of virtual participants</source>
        <translation>%1 virtueller Versuchspersonen</translation>
    </message>
    <message>
        <source>%1 in pilot sessions</source>
        <translation>%1 in Pilotsitzungen</translation>
    </message>
    <message>
        <source>predicted by %1: %2</source>
        <translation>vorhergesagt von %1: %2</translation>
    </message>
    <message>
        <source>estimates</source>
        <translation>Schätzungen</translation>
    </message>
    <message>
        <source>%1 Small open symbols: the %2 predicted by a sweep of %3, all multiplied by one factor.</source>
        <translation>%1 Kleine offene Zeichen: %2, vorhergesagt von einem Durchlauf von „sweep“ mit %3, alle mit demselben Faktor multipliziert.</translation>
    </message>
    <message>
        <source>%1 Squares are means of the participants&apos; own proportions with t-based 95 % CIs on the logit scale: the participant is the unit of analysis.</source>
        <translation>%1 Quadrate sind Mittelwerte der individuellen Anteile der Versuchspersonen mit t-basierten 95-%-KI auf der Logit-Skala: Die Versuchsperson ist die Analyseeinheit.</translation>
    </message>
    <message>
        <source>Squares are means of the participants&apos; own proportions; error bars show their t-based 95 % CIs on the logit scale: the participant is the unit of analysis.</source>
        <translation>Quadrate sind Mittelwerte der individuellen Anteile der Versuchspersonen; Fehlerbalken zeigen ihre t-basierten 95-%-KI auf der Logit-Skala: Die Versuchsperson ist die Analyseeinheit.</translation>
    </message>
    <message>
        <source>Points are means of the participants&apos; own results; error bars show their t-based %1 % CIs, for proportions on the logit scale. Overlapping CIs are not a test of a difference.</source>
        <translation>Punkte sind Mittelwerte der individuellen Ergebnisse der Versuchspersonen; Fehlerbalken zeigen ihre t-basierten %1-%-KI, für Anteile auf der Logit-Skala. Überlappende Konfidenzintervalle sind kein Test auf einen Unterschied.</translation>
    </message>
    <message>
        <source>Confusion matrix</source>
        <translation>Konfusionsmatrix</translation>
    </message>
    <message>
        <source>Numbers are counts of responses; the shade is their proportion among the responses to the stimulus. Correct responses are framed.</source>
        <translation>Zahlen sind Anzahlen von Antworten; die Tönung ist ihr Anteil an den Antworten auf den Reiz. Richtige Antworten sind umrandet.</translation>
    </message>
    <message>
        <source>proportion of the row</source>
        <translation>Anteil an der Zeile</translation>
    </message>
    <message>
        <source>response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>Reiz</translation>
    </message>
    <message>
        <source>%1 Too few confusions (pairs that were never confused: %2 of %3): the distances of these pairs are set by the ½ added to every count.</source>
        <translation>%1 Zu wenige Verwechslungen (nie verwechselte Paare: %2 von %3): Die Abstände dieser Paare sind durch das ½ bestimmt, das zu jeder Anzahl addiert wird.</translation>
    </message>
    <message>
        <source>Dendrogram of the confusions</source>
        <translation>Dendrogramm der Verwechslungen</translation>
    </message>
    <message>
        <source>MDS configuration of the dissimilarities (classical scaling)</source>
        <translation>MDS-Konfiguration der Unähnlichkeiten (klassische Skalierung)</translation>
    </message>
    <message>
        <source>Classical scaling: distances can be interpreted, directions cannot. Two dimensions account for %1 % of the sum of the absolute eigenvalues.</source>
        <translation>Klassische Skalierung: Abstände sind interpretierbar, Richtungen nicht. Auf zwei Dimensionen entfallen %1 % der Summe der absoluten Eigenwerte.</translation>
    </message>
    <message>
        <source>Filled symbols: geometric means of normalised estimates with within-participant %1 % CIs (Cousineau and Morey), which serve to compare cells and do not include the differences between participants.</source>
        <translation>Gefüllte Zeichen: geometrische Mittel der normierten Schätzungen mit %1-%-KI innerhalb der Versuchspersonen (Cousineau und Morey), die dem Vergleich von Zellen dienen und die Unterschiede zwischen den Versuchspersonen nicht enthalten.</translation>
    </message>
    <message>
        <source>Filled symbols: geometric means of normalised estimates.</source>
        <translation>Gefüllte Zeichen: geometrische Mittel der normierten Schätzungen.</translation>
    </message>
    <message>
        <source>%1 Open symbols: significant interior maxima of the curves, with CIs by the delta method.</source>
        <translation>%1 Offene Zeichen: signifikante innere Maxima der Kurven, mit Konfidenzintervallen nach der Delta-Methode.</translation>
    </message>
    <message>
        <source>%1 Open symbols: significant interior maxima of the curves.</source>
        <translation>%1 Offene Zeichen: signifikante innere Maxima der Kurven.</translation>
    </message>
    <message>
        <source>proportion, with its %1 % CI</source>
        <translation>Anteil mit %1-%-KI</translation>
    </message>
    <message>
        <source>There are no responses from which to compute a proportion; collect responses first.</source>
        <translation>Es gibt keine Antworten, aus denen sich ein Anteil berechnen ließe; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>proportion</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>all participants</source>
        <translation>alle Versuchspersonen</translation>
    </message>
    <message>
        <source>repetition %1</source>
        <translation>Wiederholung %1</translation>
    </message>
    <message>
        <source>proportion of responses (Wilson 95 % CI)</source>
        <translation>Anteil an den Antworten (95-%-KI nach Wilson)</translation>
    </message>
    <message>
        <source>Points are proportions of all responses of a row; error bars show their Wilson 95 % CIs. Open symbols are subsets, filled symbols totals.</source>
        <translation>Punkte sind Anteile an allen Antworten einer Zeile; Fehlerbalken zeigen ihre 95-%-KI nach Wilson. Offene Zeichen sind Teilmengen, gefüllte das Ganze.</translation>
    </message>
    <message>
        <source>Points are proportions of all responses of a row; error bars show their Wilson 95 % CIs.</source>
        <translation>Punkte sind Anteile an allen Antworten einer Zeile; Fehlerbalken zeigen ihre 95-%-KI nach Wilson.</translation>
    </message>
    <message>
        <source>%1 Squares are means of the participants&apos; own proportions: the participant is the unit of analysis.</source>
        <translation>%1 Quadrate sind Mittelwerte der individuellen Anteile der Versuchspersonen: Die Versuchsperson ist die Analyseeinheit.</translation>
    </message>
    <message>
        <source>Squares are means of the participants&apos; own proportions: the participant is the unit of analysis.</source>
        <translation>Quadrate sind Mittelwerte der individuellen Anteile der Versuchspersonen: Die Versuchsperson ist die Analyseeinheit.</translation>
    </message>
    <message>
        <source>mean proportion, with its 95 % CI</source>
        <translation>mittlerer Anteil mit 95-%-KI</translation>
    </message>
    <message>
        <source>mean proportion</source>
        <translation>mittlerer Anteil</translation>
    </message>
    <message>
        <source>Proportions with their CIs</source>
        <translation>Anteile mit ihren KI</translation>
    </message>
    <message>
        <source>Points are proportions; error bars show their Wilson 95 % CIs.</source>
        <translation>Punkte sind Anteile; Fehlerbalken zeigen ihre 95-%-KI nach Wilson.</translation>
    </message>
    <message>
        <source>Circles are proportions of the choices of a row with Wilson 95 % CIs, which are too narrow where a participant chose more than once. Squares are means of the participants&apos; own proportions with t-based 95 % CIs.</source>
        <translation>Kreise sind Anteile an den Wahlen einer Zeile mit 95-%-KI nach Wilson, die zu schmal sind, wenn eine Versuchsperson mehrmals gewählt hat. Quadrate sind Mittelwerte der individuellen Anteile der Versuchspersonen mit t-basierten 95-%-KI.</translation>
    </message>
    <message>
        <source>Proportions of the trials with that texture, with Wilson 95 % CIs; the rows are not independent of each other.</source>
        <translation>Anteile an den Durchgängen mit dieser Textur und ihre 95-%-KI nach Wilson; die Zeilen sind nicht unabhängig voneinander.</translation>
    </message>
    <message>
        <source>Circles are proportions of the trials with that stimulus, with Wilson 95 % CIs that treat trials as independent. The square is the mean of the participants&apos; own proportions with a t-based 95 % CI on the logit scale.</source>
        <translation>Kreise sind Anteile an den Durchgängen mit diesem Reiz, Balken ihre 95-%-KI nach Wilson, die die Durchgänge als unabhängig behandeln. Das Quadrat ist der Mittelwert der individuellen Anteile der Versuchspersonen mit t-basiertem 95-%-KI auf der Logit-Skala.</translation>
    </message>
    <message>
        <source>Proportions with Wilson 95 % CIs, one choice per participant and experiment; choices in all experiments are treated as independent.</source>
        <translation>Anteile mit 95-%-KI nach Wilson, eine Wahl je Versuchsperson und Experiment; die Wahlen in allen Experimenten werden als unabhängig behandelt.</translation>
    </message>
    <message>
        <source>The error bar shows Welch&apos;s %1 % CI of the difference of the participants&apos; means. The permutation test of group labels makes fewer assumptions.</source>
        <translation>Der Fehlerbalken zeigt das %1-%-KI nach Welch für die Differenz der Mittelwerte der Versuchspersonen. Der Permutationstest der Gruppenzugehörigkeit setzt weniger voraus.</translation>
    </message>
    <message>
        <source>Error bars show %1 % CIs: Welch&apos;s for the difference of the participants&apos; means, Newcombe&apos;s for all responses pooled, as if they were independent. The permutation test of group labels makes fewer assumptions than either.</source>
        <translation>Fehlerbalken zeigen %1-%-KI: nach Welch für die Differenz der Mittelwerte der Versuchspersonen, nach Newcombe für alle Antworten zusammen, als wären sie unabhängig. Der Permutationstest der Gruppenzugehörigkeit setzt weniger voraus als beide.</translation>
    </message>
    <message>
        <source>%1 − %2, with its %3 % CI</source>
        <translation>%1 − %2 mit %3-%-KI</translation>
    </message>
    <message>
        <source>rating, mean with its %1 % CI</source>
        <translation>Urteil, Mittelwert mit %1-%-KI</translation>
    </message>
    <message>
        <source>χ² test of equal proportions</source>
        <translation>χ²-Test auf gleiche Anteile</translation>
    </message>
    <message>
        <source>proportion correct for a given d′</source>
        <translation>Anteil richtiger Antworten bei gegebenem d′</translation>
    </message>
    <message>
        <source>Proportion correct by level</source>
        <translation>Anteil richtiger Antworten nach Stufe</translation>
    </message>
    <message>
        <source>proportion correct (for matching: of items)</source>
        <translation>Anteil richtiger Antworten (bei Zuordnungen: richtiger Zuordnungen)</translation>
    </message>
    <message>
        <source>There are no confusions from which to make a dendrogram; collect responses first.</source>
        <translation>Es gibt keine Verwechslungen, aus denen sich ein Dendrogramm berechnen ließe; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>Points are log-worths. There are no CIs, because there are too few participants or all of them made the same choices.</source>
        <translation>Punkte sind Log-Nutzwerte. Konfidenzintervalle fehlen, weil es zu wenige Versuchspersonen gibt oder alle dieselben Wahlen getroffen haben.</translation>
    </message>
    <message>
        <source>Points are log-worths with Firth&apos;s bias reduction, relative to the first item. There are no CIs over participants.</source>
        <translation>Punkte sind Log-Nutzwerte mit Firths Bias-Korrektur, bezogen auf das erste Item. Konfidenzintervalle über Versuchspersonen gibt es nicht.</translation>
    </message>
    <message>
        <source>proportion correct (for matching: of items), mean with its %1 % CI</source>
        <translation>Anteil richtiger Antworten (bei Zuordnungen: richtiger Zuordnungen), Mittelwert mit %1-%-KI</translation>
    </message>
    <message>
        <source>correctly matched items per trial, mean with its %1 % CI</source>
        <translation>richtige Zuordnungen je Durchgang, Mittelwert mit %1-%-KI</translation>
    </message>
    <message>
        <source>log-worth (centred), with its %1 % CI</source>
        <translation>Log-Nutzwert (zentriert), mit %1-%-KI</translation>
    </message>
    <message>
        <source>log-worth (centred)</source>
        <translation>Log-Nutzwert (zentriert)</translation>
    </message>
    <message>
        <source>Points are log-worths; error bars show their t-based CIs with the participants as clusters. Overlapping CIs are not a test of a difference.</source>
        <translation>Punkte sind Log-Nutzwerte; Fehlerbalken zeigen ihre t-basierten Konfidenzintervalle mit den Versuchspersonen als Clustern. Überlappende Konfidenzintervalle sind kein Test auf einen Unterschied.</translation>
    </message>
    <message>
        <source>All dissimilarities are 0, so that there are no distances to show; collect more responses.</source>
        <translation>Alle Unähnlichkeiten sind 0, daher gibt es keine Abstände; mehr Antworten erheben.</translation>
    </message>
    <message>
        <source>mean over participants</source>
        <translation>Mittelwert über Versuchspersonen</translation>
    </message>
    <message>
        <source>Points are means of the participants&apos; own results; there are no CIs.</source>
        <translation>Punkte sind Mittelwerte der individuellen Ergebnisse der Versuchspersonen; Konfidenzintervalle gibt es nicht.</translation>
    </message>
    <message>
        <source>The point is the difference of the participants&apos; means; it has no CI.</source>
        <translation>Der Punkt ist die Differenz der Mittelwerte der Versuchspersonen; sie hat kein Konfidenzintervall.</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>The dissimilarities span fewer than two dimensions, so that there is no configuration to show; collect more responses or add stimuli.</source>
        <translation>Die Unähnlichkeiten spannen weniger als zwei Dimensionen auf, daher gibt es keine Konfiguration zum Darstellen; mehr Antworten erheben oder Stimuli ergänzen.</translation>
    </message>
    <message>
        <source>all trials</source>
        <translation>alle Durchgänge</translation>
    </message>
    <message>
        <source>spacing %1 mm</source>
        <translation>Abstand %1 mm</translation>
    </message>
    <message>
        <source>Response times by condition</source>
        <translation>Reaktionszeiten nach Bedingung</translation>
    </message>
    <message>
        <source>No trial has a stored response time; collect responses first.</source>
        <translation>Für keinen Durchgang ist eine Reaktionszeit gespeichert; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>response time, with its %1 % CI</source>
        <translation>Reaktionszeit mit %1-%-KI</translation>
    </message>
    <message>
        <source>response time</source>
        <translation>Reaktionszeit</translation>
    </message>
    <message>
        <source>Points are geometric means over the participants; error bars show their t-based %1 % CIs on the logarithmic scale. Response times are measured from the cue to the response.</source>
        <translation>Punkte sind geometrische Mittel über die Versuchspersonen; Fehlerbalken zeigen ihre t-basierten %1-%-KI auf der logarithmischen Skala. Die Reaktionszeiten sind vom Signal bis zur Antwort gemessen.</translation>
    </message>
    <message>
        <source>Points are geometric means over the participants. Response times are measured from the cue to the response.</source>
        <translation>Punkte sind geometrische Mittel über die Versuchspersonen. Die Reaktionszeiten sind vom Signal bis zur Antwort gemessen.</translation>
    </message>
    <message>
        <source>No trial has a result; collect responses first.</source>
        <translation>Kein Durchgang hat ein Ergebnis; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>%1 Thin pale lines: individual participants.</source>
        <translation>%1 Dünne blasse Linien: einzelne Versuchspersonen.</translation>
    </message>
    <message>
        <source>Response times over the trials</source>
        <translation>Reaktionszeiten über die Durchgänge</translation>
    </message>
    <message>
        <source>Proportion correct over the trials (for matching: of items)</source>
        <translation>Anteil richtiger Antworten (bei Zuordnungen: richtiger Zuordnungen) über die Durchgänge</translation>
    </message>
    <message>
        <source>Points are means of the participants&apos; own proportions; error bars show their t-based %1 % CIs on the logit scale.</source>
        <translation>Punkte sind Mittelwerte der individuellen Anteile der Versuchspersonen; Fehlerbalken zeigen ihre t-basierten %1-%-KI auf der Logit-Skala.</translation>
    </message>
    <message>
        <source>Points are means of the participants&apos; own proportions.</source>
        <translation>Punkte sind Mittelwerte der individuellen Anteile der Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 Small pale marks: individual participants.</source>
        <translation>%1 Kleine blasse Zeichen: einzelne Versuchspersonen.</translation>
    </message>
    <message>
        <source>dissimilarity (Shepard)</source>
        <translation>Unähnlichkeit (Shepard)</translation>
    </message>
    <message>
        <source>Average linkage (UPGMA): clusters join at the mean dissimilarity of their textures.</source>
        <translation>Average Linkage (UPGMA): Cluster werden bei der mittleren Unähnlichkeit ihrer Texturen zusammengeführt.</translation>
    </message>
    <message>
        <source>trials of a participant, as numbered in the plan</source>
        <translation>Durchgänge einer Versuchsperson, nummeriert wie im Plan</translation>
    </message>
    <message>
        <source>proportion correct</source>
        <translation>Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>proportion of choices of the target, mean with its %1 % CI</source>
        <translation>Anteil des Ziels an den Wahlen, Mittelwert mit %1-%-KI</translation>
    </message>
    <message>
        <source>%1 (%2 % of the variance)</source>
        <translation>%1 (%2 % der Varianz)</translation>
    </message>
    <message>
        <source>%1 Parallel analysis retains no component: both may be due to chance.</source>
        <translation>%1 Die Parallelanalyse behält keine Komponente bei: Beide können zufällig sein.</translation>
    </message>
    <message>
        <source>%1 Parallel analysis retains only the first component: the second may be due to chance.</source>
        <translation>%1 Die Parallelanalyse behält nur die erste Komponente bei: Die zweite kann zufällig sein.</translation>
    </message>
    <message>
        <source>Biplot of the first two principal components</source>
        <translation>Biplot der ersten beiden Hauptkomponenten</translation>
    </message>
    <message>
        <source>There are no components: %1.</source>
        <translation>Es gibt keine Komponenten: %1.</translation>
    </message>
    <message>
        <source>There are fewer than two components, and a biplot requires two; add scales.</source>
        <translation>Es gibt weniger als zwei Komponenten, und ein Biplot erfordert zwei; Skalen ergänzen.</translation>
    </message>
    <message>
        <source>The mean ratings vary along one component only, so that there is no second axis; add scales or items.</source>
        <translation>Die mittleren Urteile variieren nur entlang einer Komponente, daher gibt es keine zweite Achse; Skalen oder Items ergänzen.</translation>
    </message>
    <message>
        <source>items</source>
        <translation>Items</translation>
    </message>
    <message>
        <source>scales (loadings)</source>
        <translation>Skalen (Ladungen)</translation>
    </message>
    <message>
        <source>scales (loadings × %1)</source>
        <translation>Skalen (Ladungen × %1)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>mean rating with its 95 % CI</source>
        <translation>mittleres Urteil mit 95-%-KI</translation>
    </message>
    <message>
        <source>mean rating</source>
        <translation>mittleres Urteil</translation>
    </message>
    <message>
        <source>%1, in % of the scale</source>
        <translation>%1, in % der Skala</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Points are means of the participants&apos; own means (n = %1), shifted within their row; error bars show their t-based 95 % CIs. Lines guide the eye.</source>
        <translation>Punkte sind Mittelwerte der individuellen Mittelwerte der Versuchspersonen (n = %1), innerhalb ihrer Zeile versetzt; Fehlerbalken zeigen ihre t-basierten 95-%-KI. Linien dienen nur der Orientierung.</translation>
    </message>
    <message>
        <source>Points are means of the participants&apos; own means (n = %1), shifted within their row; there are no CIs. Lines guide the eye.</source>
        <translation>Punkte sind Mittelwerte der individuellen Mittelwerte der Versuchspersonen (n = %1), innerhalb ihrer Zeile versetzt; es gibt keine Konfidenzintervalle. Linien dienen nur der Orientierung.</translation>
    </message>
    <message>
        <source>%1 The scales have different ranges: each row is drawn over the range of its scale.</source>
        <translation>%1 Die Skalen haben verschiedene Wertebereiche: Jede Zeile ist über den Wertebereich ihrer Skala gezeichnet.</translation>
    </message>
    <message>
        <source>Profiles of the items: mean ratings on each scale</source>
        <translation>Profile der Items: mittlere Urteile auf jeder Skala</translation>
    </message>
    <message>
        <source>The profiles of %1 items could not be distinguished in one figure (at most %2); the table has their means.</source>
        <translation>Die Profile von %1 Items ließen sich in einer Abbildung nicht unterscheiden (höchstens %2); ihre Mittelwerte stehen in der Tabelle.</translation>
    </message>
    <message>
        <source>%1 An arrow marks a CI that continues beyond the end of the scale.</source>
        <translation>%1 Ein Pfeil kennzeichnet ein Konfidenzintervall, das über das Ende der Skala hinausreicht.</translation>
    </message>
    <message>
        <source>Points are the standardised scores of the items. Arrows are the loadings of the scales: their correlations with the components. As far as the two components represent the ratings, an item in the direction of an arrow was rated high on that scale.</source>
        <translation>Punkte sind die standardisierten Komponentenwerte der Items. Pfeile sind die Ladungen der Skalen: ihre Korrelationen mit den Komponenten. Soweit die beiden Komponenten die Urteile wiedergeben, wurde ein Item in Richtung eines Pfeils auf dieser Skala hoch beurteilt.</translation>
    </message>
    <message>
        <source>Points are the standardised scores of the items. Arrows are %1 times the loadings of the scales: their correlations with the components. As far as the two components represent the ratings, an item in the direction of an arrow was rated high on that scale.</source>
        <translation>Punkte sind die standardisierten Komponentenwerte der Items. Pfeile sind das %1-Fache der Ladungen der Skalen: ihrer Korrelationen mit den Komponenten. Soweit die beiden Komponenten die Urteile wiedergeben, wurde ein Item in Richtung eines Pfeils auf dieser Skala hoch beurteilt.</translation>
    </message>
    <message>
        <source>Psychometric functions of participant %1</source>
        <translation>Psychometrische Funktionen der Versuchsperson %1</translation>
    </message>
    <message>
        <source>difference of the %1 from the standard</source>
        <translation>Differenz zum Standardreiz: %1</translation>
    </message>
    <message>
        <source>%1 of the comparison</source>
        <translation>%1 des Vergleichsreizes</translation>
    </message>
    <message>
        <source>proportion of choices</source>
        <translation>Anteil der Wahlen</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Standardreiz</translation>
    </message>
    <message>
        <source>Points of subjective equality</source>
        <translation>Punkte der subjektiven Gleichheit</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>Levels over the trials of each track</source>
        <translation>Stufen über die Durchgänge jeder Folge (Track)</translation>
    </message>
    <message>
        <source>Filled symbols: correct responses; open symbols: incorrect ones. Rings: reversals, after which the level changes its direction.</source>
        <translation>Gefüllte Symbole: richtige Antworten; offene Symbole: falsche. Ringe: Umkehrpunkte, nach denen die Stufe ihre Richtung ändert.</translation>
    </message>
    <message>
        <source>No track has a trial; collect responses first.</source>
        <translation>Keine Folge (Track) hat einen Durchgang; erst Antworten erheben.</translation>
    </message>
    <message>
        <source>trial of the track</source>
        <translation>Durchgang der Folge (Track)</translation>
    </message>
    <message>
        <source>Tracks of participant %1</source>
        <translation>Folgen (Tracks) der Versuchsperson %1</translation>
    </message>
    <message>
        <source>Filled symbols: hits (correct responses, or choices of the comparison); open symbols: other responses. Rings: reversals, after which the level changes its direction.</source>
        <translation>Gefüllte Symbole: Treffer (richtige Antworten oder Wahlen des Vergleichsreizes); offene Symbole: andere Antworten. Ringe: Umkehrpunkte, nach denen die Stufe ihre Richtung ändert.</translation>
    </message>
    <message>
        <source>Contact times by condition</source>
        <translation>Kontaktdauern nach Bedingung</translation>
    </message>
    <message>
        <source>No trial has a stored contact time; collect trials with contact first.</source>
        <translation>Für keinen Durchgang ist eine Kontaktdauer gespeichert; erst Durchgänge mit Kontakt erheben.</translation>
    </message>
    <message>
        <source>contact time per surface</source>
        <translation>Kontaktdauer je Oberfläche</translation>
    </message>
    <message>
        <source>Points are medians over the participants of each participant’s median contact time; error bars show the quartiles.</source>
        <translation>Punkte sind Mediane der medianen Kontaktdauern der Versuchspersonen; Fehlerbalken zeigen die Quartile.</translation>
    </message>
    <message>
        <source>track %1</source>
        <translation>Folge %1</translation>
    </message>
    <message>
        <source>%1, track %2</source>
        <translation>%1, Folge %2</translation>
    </message>
    <message>
        <source>run %1, track %2</source>
        <translation>Durchlauf %1, Folge %2</translation>
    </message>
    <message>
        <source>%1, run %2, track %3</source>
        <translation>%1, Durchlauf %2, Folge %3</translation>
    </message>
    <message>
        <source>%1 Lines at the lower border: drop points, the spacings from which on the tip reaches the ground between two neighbouring elements.</source>
        <translation>%1 Linien am unteren Rand: die Abstände, ab denen die Spitze zwischen zwei benachbarten Elementen den Grund erreicht (drop points).</translation>
    </message>
    <message>
        <source>proportion of responses “%1”</source>
        <translation>Anteil der Antworten „%1“</translation>
    </message>
    <message>
        <source>There is no configuration: %1.</source>
        <translation>Es gibt keine Konfiguration: %1.</translation>
    </message>
    <message>
        <source>There are no ratings from which to make a configuration; collect responses first.</source>
        <translation>Es gibt keine Urteile, aus denen sich eine Konfiguration ergibt; zuerst Antworten erheben.</translation>
    </message>
    <message>
        <source>Configuration of the items (non-metric MDS)</source>
        <translation>Konfiguration der Items (nichtmetrische MDS)</translation>
    </message>
    <message>
        <source>Distances correspond to the order of the mean dissimilarities; directions cannot be interpreted. Stress-1 in %1 dimensions: %2.</source>
        <translation>Die Abstände entsprechen der Rangfolge der mittleren Unähnlichkeiten; Richtungen lassen sich nicht deuten. Stress-1 in %1 Dimensionen: %2.</translation>
    </message>
    <message>
        <source>%1 Ellipses: 95 % of the positions in a bootstrap over participants.</source>
        <translation>%1 Ellipsen: 95 % der Positionen in einem Bootstrap über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>Shepard diagram</source>
        <translation>Shepard-Diagramm</translation>
    </message>
    <message>
        <source>A point per pair: its distance in the configuration by its mean dissimilarity. Line: disparities, the isotonic regression of the distances; stress is their deviation from the points.</source>
        <translation>Ein Punkt je Paar: sein Abstand in der Konfiguration über seiner mittleren Unähnlichkeit. Linie: Disparitäten, die isotone Regression der Abstände; der Stress ist ihre Abweichung von den Punkten.</translation>
    </message>
    <message>
        <source>pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>disparities</source>
        <translation>Disparitäten</translation>
    </message>
    <message>
        <source>mean dissimilarity</source>
        <translation>mittlere Unähnlichkeit</translation>
    </message>
    <message>
        <source>distance in the configuration</source>
        <translation>Abstand in der Konfiguration</translation>
    </message>
    <message>
        <source>Stress by the number of dimensions</source>
        <translation>Stress nach der Zahl der Dimensionen</translation>
    </message>
    <message>
        <source>Kruskal’s stress-1. Cross-validation over participants chooses the dimensions: %1.</source>
        <translation>Kruskals Stress-1. Die Kreuzvalidierung über die Versuchspersonen wählt als Zahl der Dimensionen: %1.</translation>
    </message>
    <message>
        <source>Kruskal’s stress-1.</source>
        <translation>Kruskals Stress-1.</translation>
    </message>
    <message>
        <source>non-metric scaling</source>
        <translation>nichtmetrische Skalierung</translation>
    </message>
    <message>
        <source>metric (ratio) scaling</source>
        <translation>metrische (Verhältnis-)Skalierung</translation>
    </message>
    <message>
        <source>number of dimensions</source>
        <translation>Zahl der Dimensionen</translation>
    </message>
    <message>
        <source>stress-1</source>
        <translation>Stress-1</translation>
    </message>
    <message>
        <source>Weights of the dimensions for each participant (INDSCAL)</source>
        <translation>Gewichte der Dimensionen für jede Versuchsperson (INDSCAL)</translation>
    </message>
    <message>
        <source>The farther a participant is from the origin, the better the model fits; the direction is the relative weight of the two dimensions.</source>
        <translation>Je weiter eine Versuchsperson vom Ursprung entfernt ist, desto besser passt das Modell; die Richtung ist das relative Gewicht der beiden Dimensionen.</translation>
    </message>
    <message>
        <source>Weights require two participants who rated every pair, with ratings that vary; collect more responses.</source>
        <translation>Gewichte erfordern zwei Versuchspersonen, die jedes Paar beurteilt haben und deren Urteile sich unterscheiden; weitere Antworten erheben.</translation>
    </message>
    <message>
        <source>weight of the first INDSCAL dimension</source>
        <translation>Gewicht der ersten INDSCAL-Dimension</translation>
    </message>
    <message>
        <source>weight of the second</source>
        <translation>Gewicht der zweiten</translation>
    </message>
    <message>
        <source>Dendrogram of the rated dissimilarities</source>
        <translation>Dendrogramm der beurteilten Unähnlichkeiten</translation>
    </message>
    <message>
        <source>Average linkage (UPGMA): clusters join at the mean dissimilarity of their items.</source>
        <translation>Average Linkage (UPGMA): Cluster werden bei der mittleren Unähnlichkeit ihrer Items zusammengeführt.</translation>
    </message>
    <message>
        <source>A dendrogram requires ratings of every pair; collect responses first.</source>
        <translation>Ein Dendrogramm erfordert Urteile über jedes Paar; zuerst Antworten erheben.</translation>
    </message>
    <message>
        <source>Filled symbols: geometric means of the estimates with t-based %1 % CIs over the participants.</source>
        <translation>Gefüllte Zeichen: geometrische Mittel der Schätzungen mit %1-%-KI nach t über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 Lines: power functions with the mean exponent.</source>
        <translation>%1 Linien: Potenzfunktionen mit dem mittleren Exponenten.</translation>
    </message>
    <message>
        <source>Magnitude estimates by stimulus</source>
        <translation>Größenschätzungen nach Reiz</translation>
    </message>
    <message>
        <source>There are no means, because no participant has an estimate in every cell; add the missing estimates.</source>
        <translation>Es gibt keine Mittelwerte, weil keine Versuchsperson in jeder Zelle eine Schätzung hat; ergänzen Sie die fehlenden Schätzungen.</translation>
    </message>
    <message>
        <source>normalised estimate</source>
        <translation>normierte Schätzung</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>by the delta method</source>
        <translation>nach der Delta-Methode</translation>
    </message>
    <message>
        <source>by percentiles of a bootstrap of the three outcomes</source>
        <translation>aus Perzentilen eines Bootstraps der drei Ergebnisse</translation>
    </message>
    <message>
        <source>by the delta method or, with responses “cannot tell”, by percentiles of a bootstrap of the three outcomes</source>
        <translation>nach der Delta-Methode oder, bei Antworten „kann es nicht sagen“, aus Perzentilen eines Bootstraps der drei Ergebnisse</translation>
    </message>
    <message>
        <source>by running the procedure again</source>
        <translation>durch Wiederholung des Verfahrens</translation>
    </message>
    <message>
        <source>ROC of the confidence ratings</source>
        <translation>ROC der Sicherheitsurteile</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>An ROC needs trials with and trials without a signal; collect responses of both kinds first.</source>
        <translation>Eine ROC braucht Durchgänge mit und ohne Signal; erst Antworten beider Arten erheben.</translation>
    </message>
    <message>
        <source>Points: proportions of the trials with a signal (hits) and without one (false alarms) with at least this rating, a point per criterion.</source>
        <translation>Punkte: Anteile der Durchgänge mit Signal (Treffer) und ohne Signal (falsche Alarme) mit mindestens diesem Urteil, ein Punkt je Kriterium.</translation>
    </message>
    <message>
        <source>%1 Curves: normal model with unequal variances, by maximum likelihood. Area under the curve, A_z: %2.</source>
        <translation>%1 Kurven: Normalverteilungsmodell mit ungleichen Varianzen, nach der Maximum-Likelihood-Methode. Fläche unter der Kurve, A_z: %2.</translation>
    </message>
    <message>
        <source>proportion of false alarms</source>
        <translation>Anteil falscher Alarme</translation>
    </message>
    <message>
        <source>proportion of hits</source>
        <translation>Anteil der Treffer</translation>
    </message>
    <message>
        <source>ROC of the confidence ratings of participant %1</source>
        <translation>ROC der Sicherheitsurteile der Versuchsperson %1</translation>
    </message>
    <message>
        <source>turning %1 rad</source>
        <translation>Drehung %1 rad</translation>
    </message>
    <message>
        <source>Predicted roughness by amplitude of turning</source>
        <translation>Vorhergesagte Rauheit nach der Amplitude der Drehung</translation>
    </message>
    <message>
        <source>RMS torque</source>
        <translation>Effektivwert des Drehmoments</translation>
    </message>
    <message>
        <source>power of the torque from 5 to 50 Hz</source>
        <translation>Leistung des Drehmoments von 5 bis 50 Hz</translation>
    </message>
    <message>
        <source>power of the torque from 50 to 500 Hz</source>
        <translation>Leistung des Drehmoments von 50 bis 500 Hz</translation>
    </message>
    <message>
        <source>RMS force</source>
        <translation>Effektivwert der Kraft</translation>
    </message>
    <message>
        <source>power of the force from 5 to 50 Hz</source>
        <translation>Leistung der Kraft von 5 bis 50 Hz</translation>
    </message>
    <message>
        <source>power of the force from 50 to 500 Hz</source>
        <translation>Leistung der Kraft von 50 bis 500 Hz</translation>
    </message>
    <message>
        <source>%1 Open symbols with a dot: responses “cannot tell”.</source>
        <translation>%1 Offene Symbole mit einem Punkt: Antworten „kann es nicht sagen“.</translation>
    </message>
    <message>
        <source>The first two of %1 dimensions; directions cannot be interpreted. Stress-1 in %1 dimensions: %2. Distances in all dimensions correspond to the order of the mean dissimilarities.</source>
        <translation>Die ersten zwei von %1 Dimensionen; Richtungen lassen sich nicht deuten. Stress-1 in %1 Dimensionen: %2. Die Abstände in allen Dimensionen entsprechen der Rangfolge der mittleren Unähnlichkeiten.</translation>
    </message>
    <message>
        <source>Points are means over the participants, shifted where several coincide.</source>
        <translation>Punkte sind Mittelwerte über die Versuchspersonen, verschoben, wo mehrere zusammenfallen.</translation>
    </message>
    <message>
        <source>%1 Lines guide the eye.</source>
        <translation>%1 Linien führen das Auge.</translation>
    </message>
    <message>
        <source>%1 Error bars: within-participant %2 % CIs (Cousineau and Morey), which do not include the differences between participants. Lines guide the eye.</source>
        <translation>%1 Fehlerbalken: %2-%-KIs innerhalb der Versuchspersonen (Cousineau und Morey), die die Unterschiede zwischen Versuchspersonen nicht enthalten. Linien führen das Auge.</translation>
    </message>
    <message>
        <source>%1 Error bars: t-based %2 % CIs. Lines guide the eye.</source>
        <translation>%1 Fehlerbalken: t-basierte %2-%-KIs. Linien führen das Auge.</translation>
    </message>
    <message>
        <source>rating, mean</source>
        <translation>Einstufung, Mittelwert</translation>
    </message>
    <message>
        <source>Points are means over the participants who rated every item; there are no CIs. The accompanying tests use only the ranks of the ratings.</source>
        <translation>Punkte sind Mittelwerte über die Versuchspersonen, die jedes Item eingestuft haben; es gibt keine KIs. Die zugehörigen Tests verwenden nur die Ränge der Einstufungen.</translation>
    </message>
    <message>
        <source>Configuration of the items (metric MDS)</source>
        <translation>Konfiguration der Items (metrische MDS)</translation>
    </message>
    <message>
        <source>Filled symbols: proportions correct, larger for more trials. Curves: maximum-likelihood psychometric functions.</source>
        <translation>Gefüllte Symbole: Anteile richtiger Antworten, größer bei mehr Durchgängen. Kurven: psychometrische Funktionen maximaler Likelihood.</translation>
    </message>
    <message>
        <source>Filled symbols: proportions of choices, larger for more trials. Curves: maximum-likelihood psychometric functions.</source>
        <translation>Gefüllte Symbole: Anteile der Wahlen, größer bei mehr Durchgängen. Kurven: psychometrische Funktionen maximaler Likelihood.</translation>
    </message>
    <message>
        <source>%1 Open symbols: thresholds, the level of %2 % correct</source>
        <translation>%1 Offene Symbole: Schwellen, die Stufe mit %2 % richtigen Antworten</translation>
    </message>
    <message>
        <source>%1 Open symbols: points of subjective equality</source>
        <translation>%1 Offene Symbole: Punkte subjektiver Gleichheit</translation>
    </message>
    <message>
        <source>%1, without CIs.</source>
        <translation>%1, ohne KIs.</translation>
    </message>
    <message>
        <source>%1, with %2 % CIs %3.</source>
        <translation>%1, mit %2-%-KIs %3.</translation>
    </message>
    <message>
        <source>Filled symbols: geometric means of the estimates.</source>
        <translation>Gefüllte Symbole: geometrische Mittel der Schätzungen.</translation>
    </message>
    <message>
        <source>Filled symbols: proportions of responses “%1”, larger for more trials; those at a difference of 0 are false alarms. Curves: maximum-likelihood functions of signal detection.</source>
        <translation>Gefüllte Symbole: Anteile der Antworten „%1“, größer bei mehr Durchgängen; die bei einem Unterschied von 0 sind falsche Alarme. Kurven: Funktionen der Signalentdeckung mit maximaler Likelihood.</translation>
    </message>
    <message>
        <source>%1 Open symbols: differences with d′ = 1, with 95 % CIs.</source>
        <translation>%1 Offene Symbole: Unterschiede mit d′ = 1, mit 95-%-KIs.</translation>
    </message>
    <message>
        <source>%1 Open symbols: differences with d′ = 1, without CIs.</source>
        <translation>%1 Offene Symbole: Unterschiede mit d′ = 1, ohne KIs.</translation>
    </message>
    <message>
        <source>Points are means over the participants whose threshold could be estimated</source>
        <translation>Punkte sind Mittelwerte über die Versuchspersonen, deren Schwelle geschätzt werden konnte</translation>
    </message>
    <message>
        <source>Points are geometric means over the participants whose threshold could be estimated</source>
        <translation>Punkte sind geometrische Mittel über die Versuchspersonen, deren Schwelle geschätzt werden konnte</translation>
    </message>
    <message>
        <source>%1; there are no CIs.</source>
        <translation>%1; es gibt keine KIs.</translation>
    </message>
    <message>
        <source>%1; error bars show their t-based 95 % CIs.</source>
        <translation>%1; Fehlerbalken zeigen ihre t-basierten 95-%-KIs.</translation>
    </message>
    <message>
        <source>%1; error bars show their t-based 95 % CIs on the logarithmic scale.</source>
        <translation>%1; Fehlerbalken zeigen ihre t-basierten 95-%-KIs auf der logarithmischen Skala.</translation>
    </message>
    <message>
        <source>%1 with its 95 % CI</source>
        <translation>%1 mit 95-%-KI</translation>
    </message>
    <message>
        <source>%1 A mean that leaves out thresholds outside the presented levels has no error bar; it is an upper bound if all of these lie below the levels, a lower bound if all lie above, and otherwise not drawn.</source>
        <translation>%1 Ein Mittelwert, der Schwellen außerhalb der dargebotenen Stufen auslässt, hat keinen Fehlerbalken; er ist eine obere Schranke, wenn diese alle unterhalb der Stufen liegen, eine untere, wenn alle oberhalb liegen, und sonst nicht gezeichnet.</translation>
    </message>
    <message>
        <source>point of subjective equality, mean</source>
        <translation>Punkt subjektiver Gleichheit, Mittelwert</translation>
    </message>
    <message>
        <source>threshold, geometric mean</source>
        <translation>Schwelle, geometrisches Mittel</translation>
    </message>
    <message>
        <source>difference with d′ = 1, geometric mean</source>
        <translation>Unterschied mit d′ = 1, geometrisches Mittel</translation>
    </message>
    <message>
        <source>Recorded and replayed forces</source>
        <translation>Aufgezeichnete und erneut berechnete Kräfte</translation>
    </message>
    <message>
        <source>RMS of the forces in nine bands of frequency, over all recorded presentations. The difference is that of the forces in each tick. A band without energy has no mark.</source>
        <translation>Effektivwert der Kräfte in neun Frequenzbändern über alle aufgezeichneten Darbietungen. Die Differenz ist die der Kräfte in jedem Takt. Ein Band ohne Energie hat kein Zeichen.</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>replayed force</source>
        <translation>erneut berechnete Kraft</translation>
    </message>
    <message>
        <source>force of %1</source>
        <translation>Kraft von %1</translation>
    </message>
    <message>
        <source>recorded force</source>
        <translation>aufgezeichnete Kraft</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>There is no figure, because no force has energy in any band; record presentations of a surface that was felt.</source>
        <translation>Es gibt keine Abbildung, weil keine Kraft in einem der Bänder Energie hat; zeichnen Sie Darbietungen einer gefühlten Oberfläche auf.</translation>
    </message>
    <message>
        <source>estimate, geometric mean</source>
        <translation>Schätzung, geometrisches Mittel</translation>
    </message>
    <message>
        <source>proportion correct, mean</source>
        <translation>Anteil richtig, Mittelwert</translation>
    </message>
    <message>
        <source>Responses to the anchors of the block %1, question %2</source>
        <translation>Antworten auf die Anker des Blocks %1, Frage %2</translation>
    </message>
    <message>
        <source>place of the anchor in the block</source>
        <translation>Stelle des Ankers im Block</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Points are means over the participants.</source>
        <translation>Punkte sind Mittelwerte über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>%1 Thin pale lines: the responses of individual participants in each run of the block.</source>
        <translation>%1 Dünne blasse Linien: die Antworten einzelner Versuchspersonen in jedem Lauf des Blocks.</translation>
    </message>
    <message>
        <source>at least one test of the family %1</source>
        <translation>mindestens ein Test der Familie %1</translation>
    </message>
    <message>
        <source>Power over the number of participants</source>
        <translation>Teststärke nach der Anzahl der Versuchspersonen</translation>
    </message>
    <message>
        <source>Marks: proportions of significant simulated studies, with 95 % Monte-Carlo CIs (Clopper–Pearson). Lines: monotone fits (isotonic regression). Dashed lines: powers of 80 % and 90 %.</source>
        <translation>Marken: Anteile signifikanter simulierter Studien mit 95-%-Monte-Carlo-KI (Clopper–Pearson). Linien: monotone Anpassungen (isotone Regression). Gestrichelt: Teststärken von 80 % und 90 %.</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>There is no power curve, because no study was simulated.</source>
        <translation>Es gibt keine Teststärkekurve, weil keine Studie simuliert wurde.</translation>
    </message>
    <message>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <source>mean of the participants with its %1 % CI</source>
        <translation>Mittelwert der Versuchspersonen mit seinem %1-%-KI</translation>
    </message>
    <message>
        <source>geometric mean of the participants with its %1 % CI</source>
        <translation>geometrisches Mittel der Versuchspersonen mit seinem %1-%-KI</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Wahlen</translation>
    </message>
    <message>
        <source>Scale of the items (Bradley–Terry)</source>
        <translation>Skala der Items (Bradley-Terry)</translation>
    </message>
    <message>
        <source>Scale of the items (Plackett–Luce)</source>
        <translation>Skala der Items (Plackett-Luce)</translation>
    </message>
</context>
<context>
    <name>FitTable</name>
    <message>
        <source>%1 was not written: no completed session has choices that count in analyses. Complete a session, then export again.</source>
        <translation>%1 wurde nicht geschrieben: Keine abgeschlossene Sitzung enthält Wahlen, die in Auswertungen zählen. Eine Sitzung abschließen, dann erneut exportieren.</translation>
    </message>
    <message>
        <source>%1 was not written: no factor of the trials has numeric levels (those of the factor column are repetitions). Use the other tables, or vary a factor with numeric levels.</source>
        <translation>%1 wurde nicht geschrieben: Kein Faktor der Durchgänge hat numerische Stufen (die des Faktors column sind Wiederholungen). Die anderen Tabellen verwenden oder einen Faktor mit numerischen Stufen variieren.</translation>
    </message>
    <message>
        <source>%1 was not written: no participant has choices at two levels of a numeric factor. Complete more trials, then export again.</source>
        <translation>%1 wurde nicht geschrieben: Keine Versuchsperson hat Wahlen auf zwei Stufen eines numerischen Faktors. Mehr Durchgänge abschließen, dann erneut exportieren.</translation>
    </message>
    <message>
        <source>%1 was not written: the responses are those of yes/no or same–different tasks, whose hits and false alarms are in detection.tsv.</source>
        <translation>%1 wurde nicht geschrieben: Die Antworten gehören zu Ja/Nein- oder Gleich-verschieden-Aufgaben, deren Treffer und falsche Alarme in detection.tsv stehen.</translation>
    </message>
</context>
<context>
    <name>FormWords</name>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Equalized</source>
        <translation>Egalisiert</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1.&lt;/p&gt;&lt;p&gt;In files: %2&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1.&lt;/p&gt;&lt;p&gt;In Dateien: %2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1.&lt;/p&gt;&lt;p&gt;From %2 to %3. In files: %4&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1.&lt;/p&gt;&lt;p&gt;Von %2 bis %3. In Dateien: %4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Picture width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Shortest lighting wavelength</source>
        <translation>Beleuchtung ab</translation>
    </message>
    <message>
        <source>Lighting gain</source>
        <translation>Beleuchtungsanteil</translation>
    </message>
    <message>
        <source>Detail gain</source>
        <translation>Detailverstärkung</translation>
    </message>
    <message>
        <source>Spectral tilt</source>
        <translation>Spektrale Neigung</translation>
    </message>
    <message>
        <source>Longest wavelength kept</source>
        <translation>Größte Wellenlänge</translation>
    </message>
    <message>
        <source>Roughness RMS</source>
        <translation>Rauheit (RMS)</translation>
    </message>
    <message>
        <source>Noise, standard deviation</source>
        <translation>Rauschen, SD</translation>
    </message>
    <message>
        <source>Noise, mean</source>
        <translation>Rauschen, Mittelwert</translation>
    </message>
    <message>
        <source>Friction threshold</source>
        <translation>Reibungsschwelle</translation>
    </message>
    <message>
        <source>Noise threshold</source>
        <translation>Rauschschwelle</translation>
    </message>
    <message>
        <source>Depth limit</source>
        <translation>Tiefengrenze</translation>
    </message>
    <message>
        <source>Plate stiffness k1</source>
        <translation>Plattensteifigkeit k1</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Wu et al. (2009)</source>
        <translation>Wu et al. (2009)</translation>
    </message>
    <message>
        <source>Pentland (1990)</source>
        <translation>Pentland (1990)</translation>
    </message>
    <message>
        <source>Tsai and Shah (1994)</source>
        <translation>Tsai und Shah (1994)</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Light azimuth</source>
        <translation>Azimut des Lichts</translation>
    </message>
    <message>
        <source>Light elevation</source>
        <translation>Höhenwinkel des Lichts</translation>
    </message>
</context>
<context>
    <name>GroupChoice</name>
    <message>
        <source>the protocol &quot;%1&quot; has no groups; leave out --group</source>
        <translation>Das Protokoll „%1“ hat keine Gruppen; --group weglassen</translation>
    </message>
    <message>
        <source>the protocol &quot;%1&quot; has no group &quot;%2&quot;; use %3</source>
        <translation>Das Protokoll „%1“ hat keine Gruppe „%2“; %3 verwenden</translation>
    </message>
    <message>
        <source>the participant is in the group &quot;%1&quot; of the protocol &quot;%2&quot;, and stays in it in all sessions; leave out --group</source>
        <translation>Die Versuchsperson gehört zur Gruppe „%1“ des Protokolls „%2“ und bleibt in allen Sitzungen darin; --group weglassen</translation>
    </message>
    <message>
        <source>the program assigns the groups of the protocol &quot;%1&quot;; leave out --group</source>
        <translation>Das Programm teilt die Gruppen des Protokolls „%1“ zu; --group weglassen</translation>
    </message>
    <message>
        <source>the experimenter assigns the groups of the protocol &quot;%1&quot;; state the group of the participant with --group: %2</source>
        <translation>Die Versuchsleitung teilt die Gruppen des Protokolls „%1“ zu; die Gruppe der Versuchsperson mit --group angeben: %2</translation>
    </message>
</context>
<context>
    <name>FormWords</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Scales</source>
        <translation>Skalen</translation>
    </message>
    <message>
        <source>Names of questions with a scale, all with the same minimum and maximum.</source>
        <translation>Namen von Fragen mit Skala, alle mit demselben Minimum und Maximum.</translation>
    </message>
    <message>
        <source>Reverse-keyed</source>
        <translation>Umgepolte Skalen</translation>
    </message>
    <message>
        <source>Those of the scales on which the attribute decreases; absent: none.</source>
        <translation>Diejenigen der Skalen, auf denen das Merkmal abnimmt; ohne Angabe: keine.</translation>
    </message>
    <message>
        <source>Maximum number of errors</source>
        <translation>Höchstzahl der Fehler</translation>
    </message>
    <message>
        <source>Participants with more errors in catch trials than this number are excluded.</source>
        <translation>Versuchspersonen mit mehr Fehlern in Kontrolldurchgängen als dieser Zahl werden ausgeschlossen.</translation>
    </message>
    <message>
        <source>Maximum proportion of errors</source>
        <translation>Höchster Anteil der Fehler</translation>
    </message>
    <message>
        <source>Participants with a greater proportion of errors in catch trials are excluded.</source>
        <translation>Versuchspersonen mit einem größeren Anteil von Fehlern in Kontrolldurchgängen werden ausgeschlossen.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Selection: the item that is tested against the others.</source>
        <translation>Auswahl: das Item, das gegen die anderen getestet wird.</translation>
    </message>
    <message>
        <source>A test of this kind of protocol.</source>
        <translation>Ein Test dieser Art von Protokoll.</translation>
    </message>
    <message>
        <source>Family of tests</source>
        <translation>Testfamilie</translation>
    </message>
    <message>
        <source>Equivalence margin</source>
        <translation>Äquivalenzbereich</translation>
    </message>
    <message>
        <source>Matching and recognition: equivalence margin of the difference between the mean proportions correct of two groups of participants (two one-sided tests).</source>
        <translation>Zuordnung und Wiedererkennung: Grenze, bis zu der die Differenz der mittleren Anteile richtiger Antworten zweier Gruppen von Versuchspersonen als äquivalent gilt (zwei einseitige Tests).</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <translation>Ausschluss</translation>
    </message>
    <message>
        <source>Constructs</source>
        <translation>Konstrukte</translation>
    </message>
    <message>
        <source>Rating: constructs, by name. Cronbach&apos;s alpha is computed over the scales of each.</source>
        <translation>Beurteilung: Konstrukte nach Namen. Cronbachs Alpha wird über die Skalen jedes Konstrukts berechnet.</translation>
    </message>
    <message>
        <source>The tests, declared before data collection. Further entries are stored with the study and not interpreted.</source>
        <translation>Die vor der Erhebung festgelegten Tests. Weitere Einträge werden mit der Studie gespeichert und nicht ausgewertet.</translation>
    </message>
    <message>
        <source>Scales that are to measure the same attribute of the items.</source>
        <translation>Skalen, die dasselbe Merkmal der Items messen sollen.</translation>
    </message>
    <message>
        <source>Discrimination with catch trials: participants with more errors in them are excluded; results are reported with and without these participants. One of the two limits is stated.</source>
        <translation>Unterscheidung mit Kontrolldurchgängen: Versuchspersonen mit mehr Fehlern darin werden ausgeschlossen; Ergebnisse werden mit und ohne diese Versuchspersonen berichtet. Eine der beiden Grenzen wird angegeben.</translation>
    </message>
    <message>
        <source>not analysed</source>
        <translation>nicht ausgewertet</translation>
    </message>
    <message>
        <source>analysed</source>
        <translation>ausgewertet</translation>
    </message>
    <message>
        <source>as written</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>all trials in random order</source>
        <translation>alle Durchgänge in zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>each repetition is completed before the next</source>
        <translation>jede Wiederholung wird vor der nächsten abgeschlossen</translation>
    </message>
    <message>
        <source>as listed</source>
        <translation>wie aufgeführt</translation>
    </message>
    <message>
        <source>in random order</source>
        <translation>in zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>every item in every position equally often</source>
        <translation>jedes Item gleich oft an jeder Position</translation>
    </message>
    <message>
        <source>in a new random order in every trial</source>
        <translation>in jedem Durchgang in neuer zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>every question has a separate page</source>
        <translation>jede Frage hat eine eigene Seite</translation>
    </message>
    <message>
        <source>all questions are shown together</source>
        <translation>alle Fragen werden zusammen gezeigt</translation>
    </message>
    <message>
        <source>no feedback</source>
        <translation>keine Rückmeldung</translation>
    </message>
    <message>
        <source>whether the response is correct</source>
        <translation>ob die Antwort richtig ist</translation>
    </message>
    <message>
        <source>the correct response</source>
        <translation>die richtige Antwort</translation>
    </message>
    <message>
        <source>one of two surfaces is chosen</source>
        <translation>eine von zwei Oberflächen wird gewählt</translation>
    </message>
    <message>
        <source>the comparison is chosen among two standards</source>
        <translation>der Vergleichsreiz wird unter zwei Standardreizen gewählt</translation>
    </message>
    <message>
        <source>of three surfaces, two of them equal, the odd one is chosen, which is equally often a comparison and a standard</source>
        <translation>von drei Oberflächen, zwei davon gleich, wird die abweichende gewählt, die gleich oft ein Vergleichsreiz und ein Standardreiz ist</translation>
    </message>
    <message>
        <source>one surface, the standard or the comparison, with the options yes and no</source>
        <translation>eine Oberfläche, der Standard- oder der Vergleichsreiz, mit den Antworten Ja und Nein</translation>
    </message>
    <message>
        <source>two surfaces, equal or different, with the options same and different</source>
        <translation>zwei gleiche oder verschiedene Oberflächen, mit den Antworten gleich und verschieden</translation>
    </message>
    <message>
        <source>before the trials</source>
        <translation>vor den Durchgängen</translation>
    </message>
    <message>
        <source>after half of the trials</source>
        <translation>nach der Hälfte der Durchgänge</translation>
    </message>
    <message>
        <source>after the trials</source>
        <translation>nach den Durchgängen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>The kind of experiment of this block, if it differs from that of the protocol.</source>
        <translation>Die Art des Experiments dieses Blocks, wenn sie von der des Protokolls abweicht.</translation>
    </message>
    <message>
        <source>that of the protocol</source>
        <translation>die des Protokolls</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Purpose of the trials. Only main trials are analysed.</source>
        <translation>Zweck der Durchgänge. Nur Hauptdurchgänge (main) werden ausgewertet.</translation>
    </message>
    <message>
        <source>Crossed factors</source>
        <translation>Gekreuzte Faktoren</translation>
    </message>
    <message>
        <source>Factors whose levels are all combined.</source>
        <translation>Faktoren, deren Stufen alle miteinander kombiniert werden.</translation>
    </message>
    <message>
        <source>One trial: factor and level.</source>
        <translation>Ein Durchgang: Faktor und Stufe.</translation>
    </message>
    <message>
        <source>Listed trials</source>
        <translation>Aufgeführte Durchgänge</translation>
    </message>
    <message>
        <source>List of trials, each with a level of the same factors; an alternative to crossed factors.</source>
        <translation>Liste der Durchgänge, jeder mit einer Stufe derselben Faktoren; eine Alternative zu gekreuzten Faktoren.</translation>
    </message>
    <message>
        <source>One combination: factor and level.</source>
        <translation>Eine Kombination: Faktor und Stufe.</translation>
    </message>
    <message>
        <source>Excluded combinations</source>
        <translation>Ausgelassene Kombinationen</translation>
    </message>
    <message>
        <source>Combinations of crossed or varied levels that are left out: those with all levels of an entry.</source>
        <translation>Kombinationen gekreuzter oder variierter Stufen, die ausgelassen werden: diejenigen mit allen Stufen eines Eintrags.</translation>
    </message>
    <message>
        <source>A formula of numbers, factors, +, -, *, / and parentheses, such as speed / spacing.</source>
        <translation>Eine Formel aus Zahlen, Faktoren, +, -, *, / und Klammern, zum Beispiel speed / spacing.</translation>
    </message>
    <message>
        <source>Derived factors</source>
        <translation>Abgeleitete Faktoren</translation>
    </message>
    <message>
        <source>Factors whose level in every trial is computed from levels that the block crosses, lists or varies: name and formula.</source>
        <translation>Faktoren, deren Stufe in jedem Durchgang aus Stufen berechnet wird, die der Block kreuzt, aufführt oder variiert: Name und Formel.</translation>
    </message>
    <message>
        <source>Repetitions of some trials</source>
        <translation>Einzelne Wiederholungen</translation>
    </message>
    <message>
        <source>Numbers of repetitions of some trials, in place of that of the block.</source>
        <translation>Anzahlen der Wiederholungen einzelner Durchgänge, anstelle der Anzahl des Blocks.</translation>
    </message>
    <message>
        <source>All pairs</source>
        <translation>Alle Paare</translation>
    </message>
    <message>
        <source>Varied parameter</source>
        <translation>Variierter Parameter</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Design</translation>
    </message>
    <message>
        <source>Discrimination: the surfaces of a trial, and the response.</source>
        <translation>Unterscheidung: die Oberflächen eines Durchgangs und die Antwort.</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>Number of repetitions of the combinations or rows.</source>
        <translation>Anzahl der Wiederholungen der Kombinationen oder Zeilen.</translation>
    </message>
    <message>
        <source>Drawn factors</source>
        <translation>Ausgeloste Faktoren</translation>
    </message>
    <message>
        <source>Factors drawn at random on every trial, each level equally often over the block as far as possible.</source>
        <translation>Faktoren, deren Stufe in jedem Durchgang zufällig gezogen wird, über den Block jede möglichst gleich oft.</translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Anchors, reference trials of every run of the block whose responses are stored and not analysed: factor and level. The level of the varied parameter is stated in the measure of its levels.</source>
        <translation>Anker, Vergleichsdurchgänge jedes Laufs des Blocks, deren Antworten gespeichert und nicht ausgewertet werden: Faktor und Stufe. Die Stufe des variierten Parameters wird im Maß seiner Stufen angegeben.</translation>
    </message>
    <message>
        <source>Levels of the anchor</source>
        <translation>Stufen des Ankers</translation>
    </message>
    <message>
        <source>The levels of the two surfaces of an anchor.</source>
        <translation>Die Stufen der beiden Oberflächen eines Ankers.</translation>
    </message>
    <message>
        <source>Places of the anchors</source>
        <translation>Stellen der Anker</translation>
    </message>
    <message>
        <source>Places of the anchors in every run of the block: before its trials, after half of them (of a procedure: of its largest number of trials, if it is reached), and after them.</source>
        <translation>Stellen der Anker in jedem Lauf des Blocks: vor den Durchgängen, nach der Hälfte (bei einem Verfahren: der Höchstzahl seiner Durchgänge, wenn sie erreicht wird) und danach.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Order of the trials.</source>
        <translation>Reihenfolge der Durchgänge.</translation>
    </message>
    <message>
        <source>Trials in a row.</source>
        <translation>Durchgänge nacheinander.</translation>
    </message>
    <message>
        <source>Longest run of a level</source>
        <translation>Längste Folge einer Stufe</translation>
    </message>
    <message>
        <source>For a factor: largest number of consecutive trials with the same level.</source>
        <translation>Für einen Faktor: größte Anzahl aufeinanderfolgender Durchgänge mit derselben Stufe.</translation>
    </message>
    <message>
        <source>Difference of positions.</source>
        <translation>Differenz der Positionen.</translation>
    </message>
    <message>
        <source>Smallest distance of a level</source>
        <translation>Mindestabstand einer Stufe</translation>
    </message>
    <message>
        <source>For a factor: smallest difference of the positions of two trials with the same level; 2 excludes adjacent trials.</source>
        <translation>Für einen Faktor: kleinste Differenz der Positionen zweier Durchgänge mit derselben Stufe; 2 schließt benachbarte Durchgänge aus.</translation>
    </message>
    <message>
        <source>Fixed positions</source>
        <translation>Feste Positionen</translation>
    </message>
    <message>
        <source>Positions whose trial has certain levels.</source>
        <translation>Positionen, deren Durchgang bestimmte Stufen hat.</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>The surfaces of one trial.</source>
        <translation>Die Oberflächen eines Durchgangs.</translation>
    </message>
    <message>
        <source>Order of the surfaces</source>
        <translation>Reihenfolge der Oberflächen</translation>
    </message>
    <message>
        <source>Order of the surfaces within a trial. A balanced order has every item in every position equally often over the block; in a choice between surfaces with a varied parameter and without a procedure or a criterion also within each level, if every combination of levels has a multiple of the number of surfaces as its number of trials.</source>
        <translation>Reihenfolge der Oberflächen in einem Durchgang. Eine ausbalancierte Reihenfolge hat jedes Item über den Block gleich oft an jeder Position; bei einer Wahl zwischen Oberflächen mit einem variierten Parameter und ohne Verfahren und Kriterium auch innerhalb jeder Stufe, wenn die Anzahl der Durchgänge jeder Stufenkombination ein Vielfaches der Anzahl der Oberflächen ist.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>this, or several questions</source>
        <translation>dies, oder mehrere Fragen</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>The questions of every trial, at most 12, instead of a single question.</source>
        <translation>Die Fragen jedes Durchgangs, höchstens 12, anstelle einer einzelnen Frage.</translation>
    </message>
    <message>
        <source>this, or a single question</source>
        <translation>dies, oder eine einzelne Frage</translation>
    </message>
    <message>
        <source>Order of the questions</source>
        <translation>Reihenfolge der Fragen</translation>
    </message>
    <message>
        <source>Order of the questions of a trial.</source>
        <translation>Reihenfolge der Fragen eines Durchgangs.</translation>
    </message>
    <message>
        <source>Layout of the questions</source>
        <translation>Anordnung der Fragen</translation>
    </message>
    <message>
        <source>Whether the questions are shown together, which requires scales with labels at the ends only.</source>
        <translation>Ob die Fragen zusammen gezeigt werden, was Skalen erfordert, die nur an den Enden beschriftet sind.</translation>
    </message>
    <message>
        <source>Text of the page</source>
        <translation>Text der Seite</translation>
    </message>
    <message>
        <source>The text above the questions of one page.</source>
        <translation>Der Text über den Fragen einer Seite.</translation>
    </message>
    <message>
        <source>Text for the experimenter</source>
        <translation>Text für die Versuchsleitung</translation>
    </message>
    <message>
        <source>Pictures after feeling</source>
        <translation>Bilder nach dem Fühlen</translation>
    </message>
    <message>
        <source>Surfaces can be felt again</source>
        <translation>Erneutes Fühlen möglich</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Exploration</translation>
    </message>
    <message>
        <source>The name of the exploration.</source>
        <translation>Der Name der Exploration.</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Equal roughness</source>
        <translation>Gleiche Rauheit</translation>
    </message>
    <message>
        <source>Roving</source>
        <translation>Zufallsvariation (Roving)</translation>
    </message>
    <message>
        <source>Pause before a trial</source>
        <translation>Pause vor einem Durchgang</translation>
    </message>
    <message>
        <source>Pause before every trial.</source>
        <translation>Pause vor jedem Durchgang.</translation>
    </message>
    <message>
        <source>Pause between surfaces</source>
        <translation>Pause zwischen Oberflächen</translation>
    </message>
    <message>
        <source>Pause between two surfaces.</source>
        <translation>Pause zwischen zwei Oberflächen.</translation>
    </message>
    <message>
        <source>Response deadline</source>
        <translation>Antwortfrist</translation>
    </message>
    <message>
        <source>Time to respond; absent: no limit.</source>
        <translation>Zeit für die Antwort; ohne Angabe: unbegrenzt.</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Rückmeldung</translation>
    </message>
    <message>
        <source>Feedback to the participant after a response.</source>
        <translation>Rückmeldung an die Versuchsperson nach einer Antwort.</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Trials of one kind, run together.</source>
        <translation>Durchgänge einer Art, die zusammen ablaufen.</translation>
    </message>
    <message>
        <source>the session continues, flagged</source>
        <translation>die Sitzung wird fortgesetzt und markiert</translation>
    </message>
    <message>
        <source>the session ends</source>
        <translation>die Sitzung endet</translation>
    </message>
    <message>
        <source>Correct responses</source>
        <translation>Richtige Antworten</translation>
    </message>
    <message>
        <source>Number of correct responses required.</source>
        <translation>Anzahl der erforderlichen richtigen Antworten.</translation>
    </message>
    <message>
        <source>Responses considered</source>
        <translation>Berücksichtigte Antworten</translation>
    </message>
    <message>
        <source>Number of most recent responses that are considered.</source>
        <translation>Anzahl der letzten Antworten, die berücksichtigt werden.</translation>
    </message>
    <message>
        <source>Maximum number of trials</source>
        <translation>Höchstzahl der Durchgänge</translation>
    </message>
    <message>
        <source>Number of trials after which the block ends even if the criterion is not met.</source>
        <translation>Anzahl der Durchgänge, nach der der Block auch dann endet, wenn das Kriterium nicht erreicht ist.</translation>
    </message>
    <message>
        <source>Consequence of failure</source>
        <translation>Folge bei Verfehlen</translation>
    </message>
    <message>
        <source>Consequence if the criterion is not met.</source>
        <translation>Was geschieht, wenn das Kriterium nicht erreicht wird.</translation>
    </message>
    <message>
        <source>A level.</source>
        <translation>Eine Stufe.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Levels of the stiffness.</source>
        <translation>Stufen der Steifigkeit.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Levels of the Coulomb friction coefficient.</source>
        <translation>Stufen des Coulomb-Reibungskoeffizienten.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Levels of the height of the surface&apos;s plane above that of the workspace.</source>
        <translation>Stufen der Höhe der Oberflächenebene über der des Arbeitsraums.</translation>
    </message>
    <message>
        <source>The lower limit.</source>
        <translation>Die untere Grenze.</translation>
    </message>
    <message>
        <source>The upper limit.</source>
        <translation>Die obere Grenze.</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Visits to each surface before a response is possible. In a sequence the surfaces are presented this number of times: A B, A B A B and so on.</source>
        <translation>Besuche jeder Oberfläche, bevor eine Antwort möglich ist. In einer Abfolge werden die Oberflächen so oft dargeboten: A B, A B A B usw.</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Maximum number of visits to each surface, including those on request; absent: no limit.</source>
        <translation>Höchstzahl der Besuche jeder Oberfläche einschließlich der gewünschten; ohne Angabe: unbegrenzt.</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Strokes in each visit.</source>
        <translation>Striche bei jedem Besuch.</translation>
    </message>
    <message>
        <source>Contact time</source>
        <translation>Kontaktzeit</translation>
    </message>
    <message>
        <source>Contact time of each visit.</source>
        <translation>Kontaktzeit jedes Besuchs.</translation>
    </message>
    <message>
        <source>one after the other, in the order of the trial</source>
        <translation>nacheinander, in der Reihenfolge des Durchgangs</translation>
    </message>
    <message>
        <source>2 to 4 surfaces at once, as patches of the workspace</source>
        <translation>2 bis 4 Oberflächen zugleich, als Felder des Arbeitsraums</translation>
    </message>
    <message>
        <source>one at a time, in any order that the participant chooses</source>
        <translation>einzeln, in einer Reihenfolge nach Wahl der Versuchsperson</translation>
    </message>
    <message>
        <source>along x</source>
        <translation>entlang x</translation>
    </message>
    <message>
        <source>along y</source>
        <translation>entlang y</translation>
    </message>
    <message>
        <source>a texture always has the same place on its surface</source>
        <translation>eine Textur liegt auf ihrer Oberfläche immer gleich</translation>
    </message>
    <message>
        <source>the point of the texture at the centre of the surface is drawn for every presentation</source>
        <translation>der Punkt der Textur in der Mitte der Oberfläche wird für jede Darbietung zufällig gezogen</translation>
    </message>
    <message>
        <source>How the surfaces of a trial are presented.</source>
        <translation>Wie die Oberflächen eines Durchgangs dargeboten werden.</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besuche</translation>
    </message>
    <message>
        <source>Inter-stimulus interval</source>
        <translation>Interstimulusintervall</translation>
    </message>
    <message>
        <source>The inter-stimulus interval, from the last contact with a surface to the permission to touch the next: a time, or the limits between which it is drawn for every interval. It replaces the pause between surfaces.</source>
        <translation>Das Interstimulusintervall, vom letzten Kontakt mit einer Oberfläche bis zur Freigabe der nächsten: eine Zeit oder die Grenzen, zwischen denen sie für jedes Intervall gezogen wird. Es ersetzt die Pause zwischen Oberflächen.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Darbietungsdauer</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Zwischenraum</translation>
    </message>
    <message>
        <source>Side by side: the width of the flat surface between two patches, with the stiffness and the friction of the material.</source>
        <translation>Nebeneinander: die Breite der ebenen Oberfläche zwischen zwei Feldern, mit der Steifigkeit und der Reibung des Materials.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Side by side: the axis of the workspace along which the patches lie, in the order of the trial.</source>
        <translation>Nebeneinander: die Achse des Arbeitsraums, entlang der die Felder in der Reihenfolge des Durchgangs liegen.</translation>
    </message>
    <message>
        <source>Phase of the texture</source>
        <translation>Phase der Textur</translation>
    </message>
    <message>
        <source>Place of a texture on its surface.</source>
        <translation>Lage einer Textur auf ihrer Oberfläche.</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>The factor whose levels are paired.</source>
        <translation>Der Faktor, dessen Stufen gepaart werden.</translation>
    </message>
    <message>
        <source>Both orders</source>
        <translation>Beide Reihenfolgen</translation>
    </message>
    <message>
        <source>Whether every pair is presented twice, with either level first. Otherwise it is presented once, and its order is that of the surfaces within a trial.</source>
        <translation>Ob jedes Paar zweimal dargeboten wird, mit jeder der beiden Stufen zuerst. Sonst wird es einmal dargeboten, in der Reihenfolge der Oberflächen in einem Durchgang.</translation>
    </message>
    <message>
        <source>Identical pairs</source>
        <translation>Gleiche Paare</translation>
    </message>
    <message>
        <source>Similarity: whether each level is also paired with itself, once.</source>
        <translation>Ähnlichkeit: ob jede Stufe auch einmal mit sich selbst gepaart wird.</translation>
    </message>
    <message>
        <source>Parts of the pairs</source>
        <translation>Teile der Paare</translation>
    </message>
    <message>
        <source>Similarity: the number of parts into which the pairs of different levels are divided; each participant is given one part, in which all levels occur equally often as far as possible. 1: every participant is given all pairs.</source>
        <translation>Ähnlichkeit: die Anzahl der Teile, in die die Paare verschiedener Stufen zerlegt werden; jede Versuchsperson erhält einen Teil, in dem alle Stufen möglichst gleich oft vorkommen. 1: jede Versuchsperson erhält alle Paare.</translation>
    </message>
    <message>
        <source>Matching block</source>
        <translation>Angleichender Block</translation>
    </message>
    <message>
        <source>The block that matches the surfaces: a discrimination with the judgement comparison whose procedure varies the relative amplitude.</source>
        <translation>Der Block, der die Oberflächen angleicht: eine Unterscheidung mit dem Urteil „comparison“, deren Verfahren die relative Amplitude variiert.</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Factor and level.</source>
        <translation>Faktor und Stufe.</translation>
    </message>
    <message>
        <source>Repetitions of these trials.</source>
        <translation>Wiederholungen dieser Durchgänge.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position in every run of the block, from 1.</source>
        <translation>Position in jedem Lauf des Blocks, ab 1.</translation>
    </message>
    <message>
        <source>one that can be chosen</source>
        <translation>eine, die gewählt werden kann</translation>
    </message>
    <message>
        <source>the judged surface</source>
        <translation>die beurteilte Oberfläche</translation>
    </message>
    <message>
        <source>the standard</source>
        <translation>der Standardreiz</translation>
    </message>
    <message>
        <source>the comparison</source>
        <translation>der Vergleichsreiz</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Role of the surface, determined by the kind: alternative in a selection and a paired comparison, standard or comparison in a discrimination, target otherwise.</source>
        <translation>Rolle der Oberfläche, durch die Art bestimmt: alternative bei einer Auswahl und einem Paarvergleich, standard oder comparison bei einer Unterscheidung, sonst target.</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Reiz</translation>
    </message>
    <message>
        <source>The name of the stimulus.</source>
        <translation>Der Name des Reizes.</translation>
    </message>
    <message>
        <source>Fixed factors</source>
        <translation>Festgelegte Faktoren</translation>
    </message>
    <message>
        <source>Factors fixed for this surface.</source>
        <translation>Faktoren, die für diese Oberfläche festgelegt sind.</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Item</translation>
    </message>
    <message>
        <source>Name of the surface in the responses, if the model (selection) or the texture does not distinguish the surfaces.</source>
        <translation>Name der Oberfläche in den Antworten, wenn das Modell (Auswahl) oder die Textur die Oberflächen nicht unterscheidet.</translation>
    </message>
    <message>
        <source>Practice to a criterion: the block ends when the required number of the most recent responses are correct.</source>
        <translation>Übung bis zu einem Kriterium: Der Block endet, wenn die verlangte Anzahl der letzten Antworten richtig ist.</translation>
    </message>
    <message>
        <source>Irrelevant quantities that vary at random between presentations: each presentation has one of the levels.</source>
        <translation>Irrelevante Größen, die sich zwischen Darbietungen zufällig ändern: Jede Darbietung hat eine der Stufen.</translation>
    </message>
    <message>
        <source>How the surfaces of a trial are presented.</source>
        <translation>Wie die Oberflächen eines Durchgangs dargeboten werden.</translation>
    </message>
    <message>
        <source>Visits to each surface.</source>
        <translation>Besuche jeder Oberfläche.</translation>
    </message>
    <message>
        <source>The limits between which an interval is drawn.</source>
        <translation>Die Grenzen, zwischen denen ein Intervall gezogen wird.</translation>
    </message>
    <message>
        <source>The end of every visit, the same for all surfaces: a number of strokes or a contact time. Absent: the participant ends it, within the limits of the exploration.</source>
        <translation>Das Ende jedes Besuchs, gleich für alle Oberflächen: eine Anzahl von Strichen oder eine Kontaktzeit. Ohne Angabe: Die Versuchsperson beendet ihn, innerhalb der Grenzen der Exploration.</translation>
    </message>
    <message>
        <source>Every pair of levels of a factor is a trial, in combination with crossed or listed factors: one stimulus is presented with both levels, and the level is the name of its surface in the responses.</source>
        <translation>Jedes Paar von Stufen eines Faktors ist ein Durchgang, kombiniert mit gekreuzten oder aufgeführten Faktoren: Ein Reiz wird mit beiden Stufen dargeboten, und die Stufe ist der Name seiner Oberfläche in den Antworten.</translation>
    </message>
    <message>
        <source>The surfaces are presented at the amplitudes at which the participant judged them as rough as the reference of another block, which is run before.</source>
        <translation>Die Oberflächen werden mit den Amplituden dargeboten, bei denen die Versuchsperson sie als so rau wie die Referenz eines anderen Blocks beurteilte, der vorher abläuft.</translation>
    </message>
    <message>
        <source>The trials with all of these levels, and their number of repetitions.</source>
        <translation>Die Durchgänge mit allen diesen Stufen und die Anzahl ihrer Wiederholungen.</translation>
    </message>
    <message>
        <source>A position and the levels of its trial.</source>
        <translation>Eine Position und die Stufen ihres Durchgangs.</translation>
    </message>
    <message>
        <source>One surface.</source>
        <translation>Eine Oberfläche.</translation>
    </message>
    <message>
        <source>a plate</source>
        <translation>eine Platte</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>ein Quader</translation>
    </message>
    <message>
        <source>a cylinder</source>
        <translation>ein Zylinder</translation>
    </message>
    <message>
        <source>a cylinder a tenth as long as wide</source>
        <translation>ein Zylinder, ein Zehntel so lang wie breit</translation>
    </message>
    <message>
        <source>a sphere</source>
        <translation>eine Kugel</translation>
    </message>
    <message>
        <source>along z</source>
        <translation>entlang z</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Textured mesh made by `asperity bake`; the origin of its frame is the centre of the patch (surface) or the tip (tool).</source>
        <translation>Texturiertes Netz aus `asperity bake`; der Ursprung seines Koordinatensystems ist die Mitte des Felds (Oberfläche) oder die Spitze (Werkzeug).</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>A shape instead of a mesh; a surface&apos;s highest point lies in the plane of the patch, a tool&apos;s lowest point is its tip.</source>
        <translation>Eine Form anstelle eines Netzes; der höchste Punkt einer Oberfläche liegt in der Ebene des Felds, der tiefste Punkt eines Werkzeugs ist seine Spitze.</translation>
    </message>
    <message>
        <source>A size.</source>
        <translation>Eine Größe.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of a plate or a box along x, y and z.</source>
        <translation>Größe einer Platte oder eines Quaders entlang x, y und z.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Diameter of a cylinder, a disc or a sphere. The thickness of a disc is a tenth of its diameter.</source>
        <translation>Durchmesser eines Zylinders, einer Scheibe oder einer Kugel. Die Dicke einer Scheibe ist ein Zehntel ihres Durchmessers.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of a cylinder along its axis.</source>
        <translation>Länge eines Zylinders entlang seiner Achse.</translation>
    </message>
    <message>
        <source>Direction of the axis of a cylinder or a disc, or of the axis through the poles of a sphere.</source>
        <translation>Richtung der Achse eines Zylinders oder einer Scheibe oder der Achse durch die Pole einer Kugel.</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>The texture whose height field is applied to the shape: on a plate&apos;s upper side, on all sides of a box, around a cylinder or a sphere. Absent: a surface has the texture of its stimulus, and a tool is smooth.</source>
        <translation>Die Textur, deren Höhenfeld auf die Form aufgebracht wird: auf die Oberseite einer Platte, auf alle Seiten eines Quaders, um einen Zylinder oder eine Kugel. Ohne Angabe: Eine Oberfläche hat die Textur ihres Reizes, und ein Werkzeug ist glatt.</translation>
    </message>
    <message>
        <source>A solid body: a mesh with a haptic texture, or a shape with or without a relief on it.</source>
        <translation>Ein fester Körper: ein Netz mit einer haptischen Textur oder eine Form mit oder ohne Relief.</translation>
    </message>
    <message>
        <source>A level: a number or a name.</source>
        <translation>Eine Stufe: eine Zahl oder ein Name.</translation>
    </message>
    <message>
        <source>the most realistic of several renderings is chosen</source>
        <translation>die realistischste von mehreren Wiedergaben wird gewählt</translation>
    </message>
    <message>
        <source>felt textures are assigned to the same number of pictures</source>
        <translation>gefühlte Texturen werden ebenso vielen Bildern zugeordnet</translation>
    </message>
    <message>
        <source>one felt texture is recognised among pictures</source>
        <translation>eine gefühlte Textur wird unter Bildern wiedererkannt</translation>
    </message>
    <message>
        <source>the roughness of one felt surface is estimated as a number</source>
        <translation>die Rauheit einer gefühlten Oberfläche wird als Zahl geschätzt</translation>
    </message>
    <message>
        <source>one felt surface is rated on one or more scales</source>
        <translation>eine gefühlte Oberfläche wird auf einer oder mehreren Skalen beurteilt</translation>
    </message>
    <message>
        <source>one of two felt surfaces is chosen</source>
        <translation>eine von zwei gefühlten Oberflächen wird gewählt</translation>
    </message>
    <message>
        <source>a standard and a comparison that differs from it in one parameter are felt, and one of the two is chosen</source>
        <translation>ein Standardreiz und ein Vergleichsreiz, der sich in einem Parameter unterscheidet, werden gefühlt, und einer der beiden wird gewählt</translation>
    </message>
    <message>
        <source>the dissimilarity of two felt surfaces is rated</source>
        <translation>die Unähnlichkeit zweier gefühlter Oberflächen wird beurteilt</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Lowest rate of the servo loop, in Hz.</source>
        <translation>Niedrigste Rate der Servoschleife, in Hz.</translation>
    </message>
    <message>
        <source>95 % of the rate of the servo loop</source>
        <translation>95 % der Rate der Servoschleife</translation>
    </message>
    <message>
        <source>Median lateness</source>
        <translation>Median der Verspätung</translation>
    </message>
    <message>
        <source>Largest median lateness of a tick.</source>
        <translation>Größter Median der Verspätung eines Takts.</translation>
    </message>
    <message>
        <source>Largest 99th percentile of the lateness of a tick. Default: one period.</source>
        <translation>Größtes 99. Perzentil der Verspätung eines Takts. Vorgabe: eine Periode.</translation>
    </message>
    <message>
        <source>one period</source>
        <translation>eine Periode</translation>
    </message>
    <message>
        <source>Greatest lateness</source>
        <translation>Größte Verspätung</translation>
    </message>
    <message>
        <source>Largest lateness of any tick.</source>
        <translation>Größte Verspätung irgendeines Takts.</translation>
    </message>
    <message>
        <source>Missed deadlines</source>
        <translation>Verpasste Fristen</translation>
    </message>
    <message>
        <source>Largest number of ticks in two seconds that are more than a period late.</source>
        <translation>Größte Anzahl der Takte in zwei Sekunden, die um mehr als eine Periode verspätet sind.</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Positionsrauschen</translation>
    </message>
    <message>
        <source>Largest standard deviation of positions at rest.</source>
        <translation>Größte Standardabweichung der Positionen in Ruhe.</translation>
    </message>
    <message>
        <source>Largest friction of the device.</source>
        <translation>Größte Reibung des Geräts.</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Lowest damping of the device.</source>
        <translation>Niedrigste Dämpfung des Geräts.</translation>
    </message>
    <message>
        <source>Position resolution</source>
        <translation>Positionsauflösung</translation>
    </message>
    <message>
        <source>Largest step between positions.</source>
        <translation>Größter Schritt zwischen Positionen.</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Longest time from a force to the measured motion.</source>
        <translation>Längste Zeit von einer Kraft bis zur gemessenen Bewegung.</translation>
    </message>
    <message>
        <source>Moving mass</source>
        <translation>Bewegte Masse</translation>
    </message>
    <message>
        <source>Largest moving mass.</source>
        <translation>Größte bewegte Masse.</translation>
    </message>
    <message>
        <source>Lowest resonance</source>
        <translation>Niedrigste Resonanz</translation>
    </message>
    <message>
        <source>Lower limit of the lowest resonance; a device without a resonance meets this limit.</source>
        <translation>Untere Grenze der niedrigsten Resonanz; ein Gerät ohne Resonanz hält diese Grenze ein.</translation>
    </message>
    <message>
        <source>Lower limit of the stiffest spring on which the handle comes to rest. device-test tries up to 8000 N/m.</source>
        <translation>Untere Grenze der steifsten Feder, auf der der Griff zur Ruhe kommt. device-test prüft bis 8000 N/m.</translation>
    </message>
    <message>
        <source>Force resolution</source>
        <translation>Kraftauflösung</translation>
    </message>
    <message>
        <source>Upper limit of the weakest force that moves the handle.</source>
        <translation>Obere Grenze der schwächsten Kraft, die den Griff bewegt.</translation>
    </message>
    <message>
        <source>Fraction of the workspace</source>
        <translation>Anteil des Arbeitsraums</translation>
    </message>
    <message>
        <source>Smallest fraction of the workspace that is reached. Default: 0.8.</source>
        <translation>Kleinster Anteil des Arbeitsraums, der erreicht wird. Vorgabe: 0,8.</translation>
    </message>
    <message>
        <source>`0.8`</source>
        <translation>`0.8`</translation>
    </message>
    <message>
        <source>on the processor</source>
        <translation>auf dem Prozessor</translation>
    </message>
    <message>
        <source>on the first OpenCL device</source>
        <translation>auf dem ersten OpenCL-Gerät</translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation>Rate der Servoschleife</translation>
    </message>
    <message>
        <source>Rate of the servo loop.</source>
        <translation>Rate der Servoschleife.</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>Upper limit of the force.</source>
        <translation>Obere Grenze der Kraft.</translation>
    </message>
    <message>
        <source>Missed deadlines per attempt</source>
        <translation>Verpasste Fristen je Versuch</translation>
    </message>
    <message>
        <source>An attempt with more missed deadlines than this while a surface is touched is invalid.</source>
        <translation>Ein Versuch mit mehr verpassten Fristen während der Berührung einer Oberfläche ist ungültig.</translation>
    </message>
    <message>
        <source>Gaps per attempt</source>
        <translation>Lücken je Versuch</translation>
    </message>
    <message>
        <source>An attempt with more gaps than this is invalid: times of more than two periods between two ticks while a surface is touched.</source>
        <translation>Ein Versuch mit mehr Lücken ist ungültig: Zeiten von mehr als zwei Perioden zwischen zwei Takten während der Berührung einer Oberfläche.</translation>
    </message>
    <message>
        <source>Lost records per attempt</source>
        <translation>Verlorene Werte je Versuch</translation>
    </message>
    <message>
        <source>An attempt with more lost records than this is invalid.</source>
        <translation>Ein Versuch mit mehr verlorenen Aufzeichnungswerten ist ungültig.</translation>
    </message>
    <message>
        <source>A session with a participant who is not virtual requires a device profile that is at most this old and has no failed item.</source>
        <translation>Eine Sitzung mit einer nicht virtuellen Versuchsperson erfordert ein Geräteprofil, das höchstens so alt ist und keinen nicht bestandenen Punkt hat.</translation>
    </message>
    <message>
        <source>A session with a participant who is not virtual is refused if the study has no profile of the device, or if, according to its profile, the device cannot render a stimulus or violates a limit.</source>
        <translation>Eine Sitzung mit einer nicht virtuellen Versuchsperson wird abgelehnt, wenn die Studie kein Profil des Geräts hat oder wenn das Gerät nach seinem Profil einen Reiz nicht wiedergeben kann oder eine Grenze verletzt.</translation>
    </message>
    <message>
        <source>Evaluation of contacts</source>
        <translation>Auswertung der Kontakte</translation>
    </message>
    <message>
        <source>Where the contacts of two textured bodies are evaluated: cpu, on the processor; gpu, on the first OpenCL device of the computer, sampled again in every tick and in double precision. A computer without one refuses the session.</source>
        <translation>Wo die Kontakte zweier texturierter Körper ausgewertet werden: cpu, auf dem Prozessor; gpu, auf dem ersten OpenCL-Gerät des Computers, in jedem Takt neu abgetastet und mit doppelter Genauigkeit. Ein Computer ohne ein solches lehnt die Sitzung ab.</translation>
    </message>
    <message>
        <source>Input only</source>
        <translation>Nur Eingabe</translation>
    </message>
    <message>
        <source>Whether the study needs only the hand&apos;s movement: Run then accepts a device that exerts no force. Otherwise sessions on such a device are pilots, unless the participant is virtual.</source>
        <translation>Ob die Studie nur die Bewegung der Hand benötigt: Eine Erhebung ist dann auch mit einem Gerät ohne Kraft möglich. Sonst sind Sitzungen an einem solchen Gerät Piloten, außer bei virtuellen Versuchspersonen.</translation>
    </message>
    <message>
        <source>Limits on the device</source>
        <translation>Grenzen für das Gerät</translation>
    </message>
    <message>
        <source>Requirements of the haptic device.</source>
        <translation>Anforderungen an das haptische Gerät.</translation>
    </message>
    <message>
        <source>Limits that device-test and sessions apply to the device. An item without a limit here has the default limit, if there is one.</source>
        <translation>Grenzen, die device-test und Sitzungen auf das Gerät anwenden. Für einen Punkt ohne Angabe gilt die Vorgabe, wenn es eine gibt.</translation>
    </message>
    <message>
        <source>hand, device and screen</source>
        <translation>Hand, Gerät und Bildschirm</translation>
    </message>
    <message>
        <source>the screen but not the hand</source>
        <translation>den Bildschirm, aber nicht die Hand</translation>
    </message>
    <message>
        <source>nothing: an eye mask is worn while surfaces are felt</source>
        <translation>nichts: eine Augenbinde wird getragen, während Oberflächen gefühlt werden</translation>
    </message>
    <message>
        <source>the surface shows its relief</source>
        <translation>die Oberfläche zeigt ihr Relief</translation>
    </message>
    <message>
        <source>the surface is plain</source>
        <translation>die Oberfläche ist einfarbig</translation>
    </message>
    <message>
        <source>the surface shows a pattern that belongs to no texture</source>
        <translation>die Oberfläche zeigt ein Muster, das zu keiner Textur gehört</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>in greyscale</source>
        <translation>in Graustufen</translation>
    </message>
    <message>
        <source>no noise</source>
        <translation>kein Rauschen</translation>
    </message>
    <message>
        <source>white noise</source>
        <translation>weißes Rauschen</translation>
    </message>
    <message>
        <source>pink noise</source>
        <translation>rosa Rauschen</translation>
    </message>
    <message>
        <source>Visual texture</source>
        <translation>Sichtbare Textur</translation>
    </message>
    <message>
        <source>Whether the surface shows its relief, is plain, or shows a pattern that belongs to no texture.</source>
        <translation>Ob die Oberfläche ihr Relief zeigt, einfarbig ist oder ein Muster zeigt, das zu keiner Textur gehört.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Unchanged, or in greyscale, so that colour is not a cue.</source>
        <translation>Unverändert oder in Graustufen, damit Farbe kein Hinweis ist.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Spectrum of the noise.</source>
        <translation>Spektrum des Rauschens.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Level at the ear.</source>
        <translation>Pegel am Ohr.</translation>
    </message>
    <message>
        <source>Vision</source>
        <translation>Sicht</translation>
    </message>
    <message>
        <source>What the participant sees: everything, the screen but not the hand, or nothing.</source>
        <translation>Was die Versuchsperson sieht: alles, den Bildschirm, aber nicht die Hand, oder nichts.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Recorded speech</source>
        <translation>Aufgenommene Sprache</translation>
    </message>
    <message>
        <source>Recorded speech instead of tones: cue → WAV file, relative to the study.</source>
        <translation>Aufgenommene Sprache statt Tönen: Signal → WAV-Datei, relativ zur Studie.</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>Maskierrauschen</translation>
    </message>
    <message>
        <source>What the participant sees and hears.</source>
        <translation>Was die Versuchsperson sieht und hört.</translation>
    </message>
    <message>
        <source>Object, tool and probe, shown to the participant while a surface is felt; absent: nothing is shown.</source>
        <translation>Objekt, Werkzeug und Taster, die der Versuchsperson gezeigt werden, während sie eine Oberfläche fühlt; ohne Angabe: nichts wird gezeigt.</translation>
    </message>
    <message>
        <source>Presentation of photographs to the participant.</source>
        <translation>Darbietung von Fotos für die Versuchsperson.</translation>
    </message>
    <message>
        <source>Noise over headphones that masks the sound of the device.</source>
        <translation>Rauschen über Kopfhörer, das das Geräusch des Geräts maskiert.</translation>
    </message>
    <message>
        <source>the level itself</source>
        <translation>die Stufe selbst</translation>
    </message>
    <message>
        <source>the values stated for the levels</source>
        <translation>die für die Stufen angegebenen Werte</translation>
    </message>
    <message>
        <source>the RMS texture force</source>
        <translation>der Effektivwert der Texturkraft</translation>
    </message>
    <message>
        <source>the mean normal force</source>
        <translation>die mittlere Normalkraft</translation>
    </message>
    <message>
        <source>the SD of the normal force</source>
        <translation>die SD der Normalkraft</translation>
    </message>
    <message>
        <source>the mean speed</source>
        <translation>die mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>the SD of the speed</source>
        <translation>die SD der Geschwindigkeit</translation>
    </message>
    <message>
        <source>the force at wavelengths of 5 to 10 mm</source>
        <translation>die Kraft bei Wellenlängen von 5 bis 10 mm</translation>
    </message>
    <message>
        <source>the force at wavelengths of 2.5 to 5 mm</source>
        <translation>die Kraft bei Wellenlängen von 2,5 bis 5 mm</translation>
    </message>
    <message>
        <source>the force at wavelengths of 1.25 to 2.5 mm</source>
        <translation>die Kraft bei Wellenlängen von 1,25 bis 2,5 mm</translation>
    </message>
    <message>
        <source>the force at wavelengths of 0.625 to 1.25 mm</source>
        <translation>die Kraft bei Wellenlängen von 0,625 bis 1,25 mm</translation>
    </message>
    <message>
        <source>the force at wavelengths of 0.3125 to 0.625 mm</source>
        <translation>die Kraft bei Wellenlängen von 0,3125 bis 0,625 mm</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standardreiz</translation>
    </message>
    <message>
        <source>The level of the analysed factor that is the standard.</source>
        <translation>Die Stufe des ausgewerteten Faktors, die der Standardreiz ist.</translation>
    </message>
    <message>
        <source>Assigned number</source>
        <translation>Zugewiesene Zahl</translation>
    </message>
    <message>
        <source>The number of the standard.</source>
        <translation>Die Zahl des Standardreizes.</translation>
    </message>
    <message>
        <source>every participant chooses a scale</source>
        <translation>jede Versuchsperson wählt eine Skala</translation>
    </message>
    <message>
        <source>the mean of the participant&apos;s cells</source>
        <translation>der Mittelwert der Zellen der Versuchsperson</translation>
    </message>
    <message>
        <source>the distance of the estimates of the standard from the modulus</source>
        <translation>der Abstand der Schätzungen des Standardreizes vom Modulus</translation>
    </message>
    <message>
        <source>nothing is removed</source>
        <translation>nichts wird entfernt</translation>
    </message>
    <message>
        <source>Spacings</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>The factor whose levels are spacings: numbers in metres, or textures with a stated spacing. It is stated instead of the factor of other stimuli.</source>
        <translation>Der Faktor, dessen Stufen Abstände sind: Zahlen in Metern oder Texturen mit einem angegebenen Abstand. Er wird anstelle des Faktors anderer Reize angegeben.</translation>
    </message>
    <message>
        <source>The factor whose levels are the estimated stimuli, whatever they are, or the parameter that the blocks vary. Each level is an item of the responses.</source>
        <translation>Der Faktor, dessen Stufen die geschätzten Reize sind, gleich welcher Art, oder der Parameter, den die Blöcke variieren. Jede Stufe ist ein Item der Antworten.</translation>
    </message>
    <message>
        <source>Predictor</source>
        <translation>Prädiktor</translation>
    </message>
    <message>
        <source>The physical quantity of the power function over a factor: the level itself, the values stated for the levels, or a property that is measured during the study (the RMS texture force, the mean and SD of the normal force or of the speed, the force in an octave of wavelength). Absent: geometric means by level, and no exponent.</source>
        <translation>Die physikalische Größe der Potenzfunktion über einem Faktor: die Stufe selbst, die für die Stufen angegebenen Werte oder eine Eigenschaft, die während der Studie gemessen wird (Effektivwert der Texturkraft, Mittelwert und SD der Normalkraft oder der Geschwindigkeit, Kraft in einer Oktave der Wellenlänge). Ohne Angabe: geometrische Mittel nach Stufe und kein Exponent.</translation>
    </message>
    <message>
        <source>The value of a level.</source>
        <translation>Der Wert einer Stufe.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>With stated values as the predictor: the value of each level, above 0. A level that is a number can be written in any notation.</source>
        <translation>Mit angegebenen Werten als Prädiktor: der Wert jeder Stufe, über 0. Eine Stufe, die eine Zahl ist, kann in beliebiger Schreibweise stehen.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>With the level or stated values as the predictor: its unit. Absent: that of the factor.</source>
        <translation>Mit der Stufe oder angegebenen Werten als Prädiktor: dessen Einheit. Ohne Angabe: die des Faktors.</translation>
    </message>
    <message>
        <source>Modulus</source>
        <translation>Modulus</translation>
    </message>
    <message>
        <source>free: every participant chooses a scale (free modulus). Otherwise a standard, which precedes the estimated surface in every trial, and the number assigned to it.</source>
        <translation>free: jede Versuchsperson wählt eine Skala (freier Modulus). Sonst ein Standardreiz, der der geschätzten Oberfläche in jedem Durchgang vorausgeht, und die ihm zugewiesene Zahl.</translation>
    </message>
    <message>
        <source>Normalisation</source>
        <translation>Normierung</translation>
    </message>
    <message>
        <source>What is removed from the logarithms of the estimates of a participant before means and exponents are computed: the mean of the participant&apos;s cells, the distance of the estimates of the standard from the modulus, or nothing. Absent: the mean with free modulus, nothing with a standard.</source>
        <translation>Was aus den Logarithmen der Schätzungen einer Versuchsperson entfernt wird, bevor Mittelwerte und Exponenten berechnet werden: der Mittelwert der Zellen der Versuchsperson, der Abstand der Schätzungen des Standardreizes vom Modulus oder nichts. Ohne Angabe: der Mittelwert bei freiem Modulus, nichts mit einem Standardreiz.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>The factor that is constant within a block: the probe, the force, the speed.</source>
        <translation>Der Faktor, der innerhalb eines Blocks konstant ist: Taster, Kraft, Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Magnitude: the factors of the analysis of estimates, and the modulus.</source>
        <translation>Größenschätzung: die Faktoren der Auswertung von Schätzungen und der Modulus.</translation>
    </message>
    <message>
        <source>The standard and the number assigned to it.</source>
        <translation>Der Standardreiz und die ihm zugewiesene Zahl.</translation>
    </message>
    <message>
        <source>The levels: all numbers or all names.</source>
        <translation>Die Stufen: nur Zahlen oder nur Namen.</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Meaning of the factor, for the codebook.</source>
        <translation>Bedeutung des Faktors, für das Codebook.</translation>
    </message>
    <message>
        <source>SI unit of numeric levels, such as N or m.</source>
        <translation>SI-Einheit numerischer Stufen, zum Beispiel N oder m.</translation>
    </message>
    <message>
        <source>HED tags</source>
        <translation>HED-Tags</translation>
    </message>
    <message>
        <source>HED tags of levels, by level (hedtags.org), for the sidecars of exports.</source>
        <translation>HED-Tags der Stufen, nach Stufe (hedtags.org), für die Begleitdateien der Exporte.</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>The lower limit of the band.</source>
        <translation>Die untere Grenze des Sollbereichs.</translation>
    </message>
    <message>
        <source>The intended value.</source>
        <translation>Der beabsichtigte Wert.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>The upper limit of the band.</source>
        <translation>Die obere Grenze des Sollbereichs.</translation>
    </message>
    <message>
        <source>the trial is flagged</source>
        <translation>der Durchgang wird markiert</translation>
    </message>
    <message>
        <source>the trial is repeated at once</source>
        <translation>der Durchgang wird sofort wiederholt</translation>
    </message>
    <message>
        <source>the trial is repeated at the end of the block</source>
        <translation>der Durchgang wird am Ende des Blocks wiederholt</translation>
    </message>
    <message>
        <source>only the experimenter sees it</source>
        <translation>nur die Versuchsleitung sieht sie</translation>
    </message>
    <message>
        <source>the participant sees both quantities with their bands</source>
        <translation>die Versuchsperson sieht beide Größen mit ihren Sollbereichen</translation>
    </message>
    <message>
        <source>the participant sees a moving mark to follow, and the force with its band</source>
        <translation>die Versuchsperson sieht eine bewegte Marke, der sie folgt, und die Kraft mit ihrem Sollbereich</translation>
    </message>
    <message>
        <source>the participant hears nothing inside the bands, low tones below them and high tones above them</source>
        <translation>die Versuchsperson hört innerhalb der Sollbereiche nichts, darunter tiefe und darüber hohe Töne</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of the stroke, from +x towards +y.</source>
        <translation>Richtung des Strichs, von +x nach +y.</translation>
    </message>
    <message>
        <source>Length of a stroke</source>
        <translation>Länge eines Strichs</translation>
    </message>
    <message>
        <source>Length of one stroke; the mean length of the strokes on a surface has to be in the band.</source>
        <translation>Länge eines Strichs; die mittlere Länge der Striche auf einer Oberfläche muss im Sollbereich liegen.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed of a stroke: its length divided by its time, from turn to turn.</source>
        <translation>Geschwindigkeit eines Strichs: seine Länge geteilt durch seine Zeit, von Wende zu Wende.</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>Force normal to the surface, without the ripple of its texture.</source>
        <translation>Kraft senkrecht zur Oberfläche, ohne die Welligkeit ihrer Textur.</translation>
    </message>
    <message>
        <source>Number of strokes.</source>
        <translation>Anzahl der Striche.</translation>
    </message>
    <message>
        <source>Minimum contact time</source>
        <translation>Kürzeste Kontaktzeit</translation>
    </message>
    <message>
        <source>Contact time required before a response is accepted.</source>
        <translation>Kontaktzeit, nach der eine Antwort angenommen wird.</translation>
    </message>
    <message>
        <source>Maximum contact time</source>
        <translation>Längste Kontaktzeit</translation>
    </message>
    <message>
        <source>Contact time after which the surface fades out.</source>
        <translation>Kontaktzeit, nach der die Oberfläche ausgeblendet wird.</translation>
    </message>
    <message>
        <source>Fraction in the band</source>
        <translation>Anteil im Sollbereich</translation>
    </message>
    <message>
        <source>Required fraction inside each band: of the contact time for the force, of the strokes for the speed.</source>
        <translation>Erforderlicher Anteil innerhalb jedes Sollbereichs: der Kontaktzeit bei der Kraft, der Striche bei der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Consequence of deviations</source>
        <translation>Folge von Abweichungen</translation>
    </message>
    <message>
        <source>Consequence of an exploration outside the bands.</source>
        <translation>Folge einer Exploration außerhalb der Sollbereiche.</translation>
    </message>
    <message>
        <source>Maximum number of repeats</source>
        <translation>Höchstzahl an Wiederholungen</translation>
    </message>
    <message>
        <source>Largest number of repeats of a trial.</source>
        <translation>Größte Anzahl der Wiederholungen eines Durchgangs.</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Feedback about force and speed relative to their bands.</source>
        <translation>Rückmeldung über Kraft und Geschwindigkeit relativ zu ihren Sollbereichen.</translation>
    </message>
    <message>
        <source>A variable of trials, presentations or runs of a block.</source>
        <translation>Eine Variable von Durchgängen, Darbietungen oder Läufen eines Blocks.</translation>
    </message>
    <message>
        <source>Instructed exploration of a surface, and the consequence of deviations from it.</source>
        <translation>Instruierte Exploration einer Oberfläche und die Folge von Abweichungen davon.</translation>
    </message>
    <message>
        <source>A range of a quantity: a limit, a target, or several of them.</source>
        <translation>Ein Bereich einer Größe: eine Grenze, ein Zielwert oder mehrere davon.</translation>
    </message>
    <message>
        <source>the check of the device</source>
        <translation>die Prüfung des Geräts</translation>
    </message>
    <message>
        <source>the device responds and zero force is sent</source>
        <translation>das Gerät antwortet, und die Kraft null wird gesendet</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>A text that the participant reads.</source>
        <translation>Ein Text, den die Versuchsperson liest.</translation>
    </message>
    <message>
        <source>The condition under which the text is shown.</source>
        <translation>Die Bedingung, unter der der Text gezeigt wird.</translation>
    </message>
    <message>
        <source>The groups of participants to whom the text is shown. Absent: all participants.</source>
        <translation>Die Gruppen von Versuchspersonen, denen der Text gezeigt wird. Ohne Angabe: alle Versuchspersonen.</translation>
    </message>
    <message>
        <source>A group: a level of the factor of the groups.</source>
        <translation>Eine Gruppe: eine Stufe des Faktors der Gruppen.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>The surface is removed, and the check is passed if the device responds and zero force is sent.</source>
        <translation>Die Oberfläche wird entfernt, und die Prüfung ist bestanden, wenn das Gerät antwortet und die Kraft null gesendet wird.</translation>
    </message>
    <message>
        <source>Break</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>The block to run.</source>
        <translation>Der Block, der abläuft.</translation>
    </message>
    <message>
        <source>Factor of the runs</source>
        <translation>Faktor der Läufe</translation>
    </message>
    <message>
        <source>A factor; the block runs once per level, in the counterbalanced order.</source>
        <translation>Ein Faktor; der Block läuft einmal je Stufe ab, in der ausbalancierten Reihenfolge.</translation>
    </message>
    <message>
        <source>Trials between breaks</source>
        <translation>Durchgänge zwischen Pausen</translation>
    </message>
    <message>
        <source>The number of trials after which there is a break.</source>
        <translation>Die Anzahl der Durchgänge, nach der es eine Pause gibt.</translation>
    </message>
    <message>
        <source>Contact between breaks</source>
        <translation>Kontakt zwischen Pausen</translation>
    </message>
    <message>
        <source>The time in contact with surfaces, in minutes, after which there is a break, measured since the last break.</source>
        <translation>Die Kontaktzeit mit Oberflächen in Minuten, nach der es eine Pause gibt, gemessen seit der letzten Pause.</translation>
    </message>
    <message>
        <source>The questions of this step.</source>
        <translation>Die Fragen dieses Schritts.</translation>
    </message>
    <message>
        <source>Shortest duration</source>
        <translation>Kürzeste Dauer</translation>
    </message>
    <message>
        <source>Shortest duration of the break.</source>
        <translation>Kürzeste Dauer der Pause.</translation>
    </message>
    <message>
        <source>Text for the participant during the break.</source>
        <translation>Text für die Versuchsperson während der Pause.</translation>
    </message>
    <message>
        <source>Check of zero force</source>
        <translation>Prüfung der Kraft null</translation>
    </message>
    <message>
        <source>Whether the break begins with a check that the device responds and zero force is sent.</source>
        <translation>Ob die Pause mit einer Prüfung beginnt, ob das Gerät antwortet und die Kraft null gesendet wird.</translation>
    </message>
    <message>
        <source>Check of the drift</source>
        <translation>Prüfung der Drift</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Aufforderung</translation>
    </message>
    <message>
        <source>Request to the experimenter to have the handle released, so that it rests; confirmed before the recording.</source>
        <translation>Aufforderung an die Versuchsleitung, den Griff loslassen zu lassen, damit er ruht; vor der Aufzeichnung bestätigt.</translation>
    </message>
    <message>
        <source>Request to hold the tip at a fixed reference point; with it a second recording is made there.</source>
        <translation>Aufforderung, die Spitze an einen festen Bezugspunkt zu halten; mit ihr gibt es dort eine zweite Aufzeichnung.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Duration of each recording.</source>
        <translation>Dauer jeder Aufzeichnung.</translation>
    </message>
    <message>
        <source>One step of the session: a text, a check, a break, a run of a block, or questions.</source>
        <translation>Ein Schritt der Sitzung: ein Text, eine Prüfung, eine Pause, ein Lauf eines Blocks oder Fragen.</translation>
    </message>
    <message>
        <source>A break in which the participant rests.</source>
        <translation>Eine Pause, in der die Versuchsperson ruht.</translation>
    </message>
    <message>
        <source>Before the participant rests, the reading of the device is recorded while no hand moves it and no force is sent.</source>
        <translation>Bevor die Versuchsperson ruht, wird der Messwert des Geräts aufgezeichnet, während keine Hand es bewegt und keine Kraft gesendet wird.</translation>
    </message>
    <message>
        <source>equal differences</source>
        <translation>gleiche Differenzen</translation>
    </message>
    <message>
        <source>equal differences of the logarithm</source>
        <translation>gleiche Differenzen des Logarithmus</translation>
    </message>
    <message>
        <source>decibels of an amplitude</source>
        <translation>Dezibel einer Amplitude</translation>
    </message>
    <message>
        <source>equal ratios</source>
        <translation>gleiche Verhältnisse</translation>
    </message>
    <message>
        <source>Lowest level</source>
        <translation>Niedrigste Stufe</translation>
    </message>
    <message>
        <source>Of a grid: the lowest level.</source>
        <translation>Bei einem Raster: die niedrigste Stufe.</translation>
    </message>
    <message>
        <source>Highest level</source>
        <translation>Höchste Stufe</translation>
    </message>
    <message>
        <source>Of a grid: the upper limit of the levels.</source>
        <translation>Bei einem Raster: die obere Grenze der Stufen.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Of a grid: the step, in the unit of its scale; with the scale ratio, a ratio above 1.</source>
        <translation>Bei einem Raster: der Schritt, in der Einheit seiner Skala; mit der Skala ratio ein Verhältnis über 1.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Of a grid: the scale on which its steps are equal: linear, log10, db (decibels of an amplitude) or ratio.</source>
        <translation>Bei einem Raster: die Skala, auf der seine Schritte gleich sind: linear, log10, db (Dezibel einer Amplitude) oder ratio.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>The parameter of the force model, or &quot;relative_amplitude&quot;: a factor by which the amplitude of the texture is multiplied, whatever the force model and whatever determines the amplitude otherwise; a standard has the value 1.</source>
        <translation>Der Parameter des Kraftmodells oder „relative_amplitude“: ein Faktor, mit dem die Amplitude der Textur multipliziert wird, gleich bei welchem Kraftmodell und was die Amplitude sonst bestimmt; ein Standardreiz hat den Wert 1.</translation>
    </message>
    <message>
        <source>Name of the factor in the data; the name of the parameter by default.</source>
        <translation>Name des Faktors in den Daten; Vorgabe ist der Name des Parameters.</translation>
    </message>
    <message>
        <source>Varied surface</source>
        <translation>Variierte Oberfläche</translation>
    </message>
    <message>
        <source>Role of the surface whose parameter is varied.</source>
        <translation>Rolle der Oberfläche, deren Parameter variiert wird.</translation>
    </message>
    <message>
        <source>Reference surface</source>
        <translation>Bezugsoberfläche</translation>
    </message>
    <message>
        <source>Role of the surface to which levels refer; its stimulus states the parameter, unless this is the relative amplitude.</source>
        <translation>Rolle der Oberfläche, auf die sich die Stufen beziehen; ihr Reiz gibt den Parameter an, außer wenn dieser die relative Amplitude ist.</translation>
    </message>
    <message>
        <source>Values of the parameter, in its unit: a list, or a grid of equal steps.</source>
        <translation>Werte des Parameters, in seiner Einheit: eine Liste oder ein Raster mit gleichen Schritten.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenzen</translation>
    </message>
    <message>
        <source>Differences from the standard, in the unit of the parameter: a list or a grid.</source>
        <translation>Differenzen vom Standardreiz, in der Einheit des Parameters: eine Liste oder ein Raster.</translation>
    </message>
    <message>
        <source>Differences in per cent</source>
        <translation>Differenzen in Prozent</translation>
    </message>
    <message>
        <source>Differences from the standard in per cent of the standard: a list or a grid.</source>
        <translation>Differenzen vom Standardreiz in Prozent des Standardreizes: eine Liste oder ein Raster.</translation>
    </message>
    <message>
        <source>Ratios</source>
        <translation>Verhältnisse</translation>
    </message>
    <message>
        <source>Ratios to the standard: a list or a grid.</source>
        <translation>Verhältnisse zum Standardreiz: eine Liste oder ein Raster.</translation>
    </message>
    <message>
        <source>Decibels</source>
        <translation>Dezibel</translation>
    </message>
    <message>
        <source>Levels re the standard in decibels, 20·log10 of the ratio: a list or a grid.</source>
        <translation>Stufen relativ zum Standardreiz in Dezibel, 20·log10 des Verhältnisses: eine Liste oder ein Raster.</translation>
    </message>
    <message>
        <source>A step.</source>
        <translation>Ein Schritt.</translation>
    </message>
    <message>
        <source>Lowest value.</source>
        <translation>Niedrigster Wert.</translation>
    </message>
    <message>
        <source>Highest value.</source>
        <translation>Höchster Wert.</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Anzahl der Werte</translation>
    </message>
    <message>
        <source>Number of values.</source>
        <translation>Anzahl der Werte.</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>Thresholds in steps of equal ratio, as differences of level from the standard; absent: 41 from the smallest to the greatest difference of the levels.</source>
        <translation>Schwellen in Schritten gleichen Verhältnisses, als Differenzen der Stufe vom Standardreiz; ohne Angabe: 41 von der kleinsten bis zur größten Differenz der Stufen.</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Steigungen</translation>
    </message>
    <message>
        <source>Slopes β in steps of equal ratio; absent: 8 from 1 to 8.</source>
        <translation>Steigungen β in Schritten gleichen Verhältnisses; ohne Angabe: 8 von 1 bis 8.</translation>
    </message>
    <message>
        <source>Lapse rates</source>
        <translation>Fehlerraten (lapse rates)</translation>
    </message>
    <message>
        <source>Lapse rates in equal steps; absent: 4 from 0 to 0.06.</source>
        <translation>Fehlerraten (lapse rates) in gleichen Schritten; ohne Angabe: 4 von 0 bis 0,06.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>The upper end of the 95 % credible interval of the threshold is at most this many times the lower end.</source>
        <translation>Das obere Ende des 95-%-Glaubwürdigkeitsintervalls der Schwelle ist höchstens so viele Male das untere Ende.</translation>
    </message>
    <message>
        <source>Minimum number of trials</source>
        <translation>Mindestzahl der Durchgänge</translation>
    </message>
    <message>
        <source>Minimum number of trials of the track.</source>
        <translation>Mindestzahl der Durchgänge der Folge (Track).</translation>
    </message>
    <message>
        <source>Minimum of each response</source>
        <translation>Mindestzahl je Antwort</translation>
    </message>
    <message>
        <source>Minimum number of correct responses, and of incorrect responses.</source>
        <translation>Mindestzahl der richtigen und der falschen Antworten.</translation>
    </message>
    <message>
        <source>Maximum number of trials of a track.</source>
        <translation>Höchstzahl der Durchgänge einer Folge (Track).</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Umkehrpunkte</translation>
    </message>
    <message>
        <source>Up-down: number of reversals.</source>
        <translation>Up-down-Verfahren: Anzahl der Umkehrpunkte.</translation>
    </message>
    <message>
        <source>Clipped moves</source>
        <translation>Begrenzte Schritte</translation>
    </message>
    <message>
        <source>Up-down: number of moves in succession that the lowest or highest level shortened or prevented; absent: the track stays at this level until a move leads away from it.</source>
        <translation>Up-down-Verfahren: Anzahl aufeinanderfolgender Schritte, die die niedrigste oder höchste Stufe verkürzte oder verhinderte; ohne Angabe: Die Folge bleibt auf dieser Stufe, bis ein Schritt von ihr wegführt.</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>The level of its first trial, if it differs.</source>
        <translation>Die Stufe ihres ersten Durchgangs, wenn sie abweicht.</translation>
    </message>
    <message>
        <source>the comparison at an easy level, an error in which is a lapse of attention</source>
        <translation>der Vergleichsreiz mit einer leichten Stufe, ein Fehler ist hier eine Aufmerksamkeitslücke</translation>
    </message>
    <message>
        <source>the standard twice with the judgement performance, every choice in which is a false alarm</source>
        <translation>zweimal der Standardreiz mit dem Urteil performance, jede Wahl ist hier ein falscher Alarm</translation>
    </message>
    <message>
        <source>the standard twice with the judgement comparison</source>
        <translation>zweimal der Standardreiz mit dem Urteil comparison</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Surfaces of the catch trials.</source>
        <translation>Oberflächen der Kontrolldurchgänge.</translation>
    </message>
    <message>
        <source>Of the type easy, which requires it: level of the catch trials, in the measure of the levels of the varied parameter; at least as easy as the easiest of them.</source>
        <translation>Beim Typ easy, der sie erfordert: Stufe der Kontrolldurchgänge, im Maß der Stufen des variierten Parameters; mindestens so leicht wie die leichteste von ihnen.</translation>
    </message>
    <message>
        <source>Trials per catch trial</source>
        <translation>Durchgänge je Kontrolle</translation>
    </message>
    <message>
        <source>Number of consecutive trials of the block that contain one catch trial.</source>
        <translation>Anzahl aufeinanderfolgender Durchgänge des Blocks, unter denen ein Kontrolldurchgang ist.</translation>
    </message>
    <message>
        <source>every level equally often, in random order</source>
        <translation>jede Stufe gleich oft, in zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>down after a number of correct responses in succession, up after a number of incorrect ones</source>
        <translation>abwärts nach einer Anzahl richtiger Antworten in Folge, aufwärts nach einer Anzahl falscher</translation>
    </message>
    <message>
        <source>down after a correct response, up by a larger step after an incorrect one</source>
        <translation>abwärts nach einer richtigen Antwort, um einen größeren Schritt aufwärts nach einer falschen</translation>
    </message>
    <message>
        <source>the level from which the most is expected about the threshold</source>
        <translation>die Stufe, die am meisten über die Schwelle erwarten lässt</translation>
    </message>
    <message>
        <source>the level from which the most is expected about threshold, slope and lapse rate</source>
        <translation>die Stufe, die am meisten über Schwelle, Steigung und Fehlerrate (lapse rate) erwarten lässt</translation>
    </message>
    <message>
        <source>the level that a program of the laboratory states</source>
        <translation>die Stufe, die ein Programm des Labors angibt</translation>
    </message>
    <message>
        <source>the slope</source>
        <translation>die Steigung</translation>
    </message>
    <message>
        <source>the lapse rate</source>
        <translation>die Fehlerrate (lapse rate)</translation>
    </message>
    <message>
        <source>A nuisance parameter.</source>
        <translation>Ein Störparameter.</translation>
    </message>
    <message>
        <source>Any object.</source>
        <translation>Ein beliebiges Objekt.</translation>
    </message>
    <message>
        <source>the level is presented again in another trial</source>
        <translation>die Stufe wird in einem anderen Durchgang noch einmal dargeboten</translation>
    </message>
    <message>
        <source>an incorrect response</source>
        <translation>eine falsche Antwort</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>The method that chooses the levels. A program of the laboratory is given by run --external or in the window, and never by a file.</source>
        <translation>Die Methode, die die Stufen wählt. Ein Programm des Labors wird mit run --external oder im Fenster gewählt und nie in einer Datei.</translation>
    </message>
    <message>
        <source>Constant stimuli: number of presentations of every level.</source>
        <translation>Konstante Reize: Anzahl der Darbietungen jeder Stufe.</translation>
    </message>
    <message>
        <source>Responses before a move down</source>
        <translation>Antworten je Abwärtsschritt</translation>
    </message>
    <message>
        <source>Transformed up-down: number of correct responses in succession before a move down.</source>
        <translation>Transformiertes Up-down-Verfahren: Anzahl richtiger Antworten in Folge vor einem Schritt abwärts.</translation>
    </message>
    <message>
        <source>Responses before a move up</source>
        <translation>Antworten je Aufwärtsschritt</translation>
    </message>
    <message>
        <source>Transformed up-down: number of incorrect responses in succession before a move up.</source>
        <translation>Transformiertes Up-down-Verfahren: Anzahl falscher Antworten in Folge vor einem Schritt aufwärts.</translation>
    </message>
    <message>
        <source>Weighted up-down: proportion correct at the target level. Psi and QUEST+: proportion correct at the threshold; 2/3 by default where one of three surfaces is chosen.</source>
        <translation>Gewichtetes Up-down-Verfahren: Anteil richtiger Antworten bei der Zielstufe. Psi und QUEST+: Anteil richtiger Antworten an der Schwelle; Vorgabe 2/3, wo eine von drei Oberflächen gewählt wird.</translation>
    </message>
    <message>
        <source>Up-down: the level of the first trial of a track.</source>
        <translation>Up-down-Verfahren: die Stufe des ersten Durchgangs einer Folge (Track).</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Up-down: the step, in the unit of the scale of the grid. If several are listed, each reversal selects the next one.</source>
        <translation>Up-down-Verfahren: der Schritt, in der Einheit der Skala des Rasters. Sind mehrere aufgeführt, gilt nach jedem Umkehrpunkt der nächste.</translation>
    </message>
    <message>
        <source>Steps up</source>
        <translation>Schritte aufwärts</translation>
    </message>
    <message>
        <source>Transformed up-down: the steps of moves up, if they are not those of all moves.</source>
        <translation>Transformiertes Up-down-Verfahren: die Schritte aufwärts, wenn sie nicht die aller Bewegungen sind.</translation>
    </message>
    <message>
        <source>Steps down</source>
        <translation>Schritte abwärts</translation>
    </message>
    <message>
        <source>Up-down: the steps of moves down, if they are not those of all moves.</source>
        <translation>Up-down-Verfahren: die Schritte abwärts, wenn sie nicht die aller Bewegungen sind.</translation>
    </message>
    <message>
        <source>Prior</source>
        <translation>A-priori-Verteilung</translation>
    </message>
    <message>
        <source>Nuisance parameters</source>
        <translation>Störparameter</translation>
    </message>
    <message>
        <source>Psi: the nuisance parameters, on which no trials are spent.</source>
        <translation>Psi: die Störparameter, auf die keine Durchgänge verwendet werden.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>External: settings that the program receives unchanged; they are not interpreted.</source>
        <translation>Extern: Einstellungen, die das Programm unverändert erhält; sie werden nicht ausgewertet.</translation>
    </message>
    <message>
        <source>Time to answer</source>
        <translation>Zeit bis zur Antwort</translation>
    </message>
    <message>
        <source>External: the time in seconds within which the program must answer.</source>
        <translation>Extern: die Zeit in Sekunden, innerhalb derer das Programm antworten muss.</translation>
    </message>
    <message>
        <source>Stopping rule</source>
        <translation>Abbruchregel</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Folgen (Tracks)</translation>
    </message>
    <message>
        <source>Interleaved tracks of each combination of the levels of the other factors; one track by default.</source>
        <translation>Verschränkte Folgen (Tracks) jeder Kombination der Stufen der anderen Faktoren; Vorgabe ist eine Folge.</translation>
    </message>
    <message>
        <source>Missed response deadline</source>
        <translation>Verpasste Antwortfrist</translation>
    </message>
    <message>
        <source>What a missed response deadline means.</source>
        <translation>Was eine verpasste Antwortfrist bedeutet.</translation>
    </message>
    <message>
        <source>Catch trials</source>
        <translation>Kontrolldurchgänge</translation>
    </message>
    <message>
        <source>A grid of levels.</source>
        <translation>Ein Raster von Stufen.</translation>
    </message>
    <message>
        <source>The parameter that the trials vary: a factor whose levels are values of one parameter of one of the surfaces, in combination with the other factors of the block. The levels are stated in exactly one of the measures.</source>
        <translation>Der Parameter, den die Durchgänge variieren: ein Faktor, dessen Stufen Werte eines Parameters einer der Oberflächen sind, kombiniert mit den anderen Faktoren des Blocks. Die Stufen werden in genau einem der Maße angegeben.</translation>
    </message>
    <message>
        <source>A range of values.</source>
        <translation>Ein Wertebereich.</translation>
    </message>
    <message>
        <source>A range of lapse rates.</source>
        <translation>Ein Bereich von Fehlerraten (lapse rates).</translation>
    </message>
    <message>
        <source>Psi and QUEST+: the values of the parameters of a Weibull function of the difference from the standard, all equally probable before the first response.</source>
        <translation>Psi und QUEST+: die Werte der Parameter einer Weibull-Funktion der Differenz zum Standardreiz, vor der ersten Antwort alle gleich wahrscheinlich.</translation>
    </message>
    <message>
        <source>Psi and QUEST+: a precise threshold.</source>
        <translation>Psi und QUEST+: eine genaue Schwelle.</translation>
    </message>
    <message>
        <source>Up-down, psi, QUEST+ and external: a track ends when the first of these rules applies.</source>
        <translation>Up-down-Verfahren, Psi, QUEST+ und extern: Eine Folge (Track) endet, wenn die erste dieser Regeln zutrifft.</translation>
    </message>
    <message>
        <source>One track.</source>
        <translation>Eine Folge (Track).</translation>
    </message>
    <message>
        <source>Trials with a known response at random places among the others; no threshold is estimated from them.</source>
        <translation>Durchgänge mit bekannter Antwort an zufälligen Stellen zwischen den anderen; aus ihnen wird keine Schwelle geschätzt.</translation>
    </message>
    <message>
        <source>The procedure that chooses the levels of the varied parameter from the responses.</source>
        <translation>Das Verfahren, das die Stufen des variierten Parameters aus den Antworten wählt.</translation>
    </message>
    <message>
        <source>a selection, a matching or a recognition is guessed</source>
        <translation>eine Auswahl, eine Zuordnung oder eine Wiedererkennung wird geraten</translation>
    </message>
    <message>
        <source>the texture&apos;s true height field</source>
        <translation>das wahre Höhenfeld der Textur</translation>
    </message>
    <message>
        <source>the features that the texture states</source>
        <translation>die Merkmale, die die Textur angibt</translation>
    </message>
    <message>
        <source>the lateral force, relative to the mean normal force</source>
        <translation>die Seitenkraft relativ zur mittleren Normalkraft</translation>
    </message>
    <message>
        <source>the normal force, relative to the mean normal force</source>
        <translation>die Normalkraft relativ zur mittleren Normalkraft</translation>
    </message>
    <message>
        <source>the acceleration of a held tool</source>
        <translation>die Beschleunigung eines gehaltenen Werkzeugs</translation>
    </message>
    <message>
        <source>the depth to which the surface yields over the normal force</source>
        <translation>die Tiefe, um die die Oberfläche nachgibt, je Normalkraft</translation>
    </message>
    <message>
        <source>it increases with the parameter</source>
        <translation>sie nimmt mit dem Parameter zu</translation>
    </message>
    <message>
        <source>it decreases with the parameter</source>
        <translation>sie nimmt mit dem Parameter ab</translation>
    </message>
    <message>
        <source>Expectation</source>
        <translation>Erwartung</translation>
    </message>
    <message>
        <source>Expectation of a texture: none (a selection, a matching or a recognition is then guessed), its true height field (if it is felt on bodies only: these bodies), or the stated prior.</source>
        <translation>Erwartung von einer Textur: none (eine Auswahl, eine Zuordnung oder eine Wiedererkennung wird dann geraten), ihr wahres Höhenfeld (wenn sie nur an Körpern gefühlt wird: diese Körper) oder die angegebenen erwarteten Merkmale.</translation>
    </message>
    <message>
        <source>Cut-off wavelength</source>
        <translation>Grenzwellenlänge</translation>
    </message>
    <message>
        <source>With true height fields as the expectation: cut-off wavelength of the Gaussian low-pass whose result is subtracted from the expected heights, as from heights of a photograph. Absent: nothing is subtracted.</source>
        <translation>Mit wahren Höhenfeldern als Erwartung: Grenzwellenlänge des Gauß-Tiefpasses, dessen Ergebnis von den erwarteten Höhen abgezogen wird, wie von Höhen aus einem Foto. Ohne Angabe: nichts wird abgezogen.</translation>
    </message>
    <message>
        <source>Forces ignored</source>
        <translation>Kräfte unbeachtet</translation>
    </message>
    <message>
        <source>Whether the felt forces are ignored.</source>
        <translation>Ob die gefühlten Kräfte unbeachtet bleiben.</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Standard deviation of the noise added to every feature.</source>
        <translation>Standardabweichung des Rauschens, das zu jedem Merkmal addiert wird.</translation>
    </message>
    <message>
        <source>Position bias</source>
        <translation>Positionstendenz</translation>
    </message>
    <message>
        <source>Evidence added to the first position.</source>
        <translation>Evidenz, die zur ersten Position addiert wird.</translation>
    </message>
    <message>
        <source>Lapse rate</source>
        <translation>Fehlerrate (lapse rate)</translation>
    </message>
    <message>
        <source>Lapse rate: the probability of a guess.</source>
        <translation>Fehlerrate (lapse rate): die Wahrscheinlichkeit, dass geraten wird.</translation>
    </message>
    <message>
        <source>Judged quantity</source>
        <translation>Beurteilte Größe</translation>
    </message>
    <message>
        <source>Magnitude, paired comparison, discrimination and rating: the judged quantity, which is a felt force relative to the mean normal force, the acceleration of a held tool, or the depth to which the surface yields over the normal force.</source>
        <translation>Größenschätzung, Paarvergleich, Unterscheidung und Beurteilung: die beurteilte Größe, nämlich eine gefühlte Kraft relativ zur mittleren Normalkraft, die Beschleunigung eines gehaltenen Werkzeugs oder die Tiefe, um die die Oberfläche nachgibt, je Normalkraft.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>Effect of the parameter</source>
        <translation>Wirkung des Parameters</translation>
    </message>
    <message>
        <source>Criterion of yes</source>
        <translation>Kriterium für Ja</translation>
    </message>
    <message>
        <source>Discrimination with the options yes and no: the magnitude above which the response is yes, in the unit of the judged quantity: as a fraction of the mean normal force, in m/s² or in mm/N; below which, where a signal has the smaller magnitude.</source>
        <translation>Unterscheidung mit den Antworten Ja und Nein: die Größe, oberhalb derer die Antwort Ja ist, in der Einheit der beurteilten Größe: als Bruchteil der mittleren Normalkraft, in m/s² oder in mm/N; unterhalb derer, wo ein Signal die kleinere Größe hat.</translation>
    </message>
    <message>
        <source>Criterion of different</source>
        <translation>Kriterium für verschieden</translation>
    </message>
    <message>
        <source>Discrimination with the options same and different: the relative difference of two magnitudes from which on the response is different; 0.1 is a difference of 10 %.</source>
        <translation>Unterscheidung mit den Antworten gleich und verschieden: die relative Differenz zweier Größen, ab der die Antwort verschieden ist; 0,1 ist eine Differenz von 10 %.</translation>
    </message>
    <message>
        <source>Criterion of uncertainty</source>
        <translation>Kriterium für Unsicherheit</translation>
    </message>
    <message>
        <source>Discrimination with the option &quot;I cannot tell&quot;: the relative difference of two magnitudes below which this is the response; 0.1 is a difference of 10 %.</source>
        <translation>Unterscheidung mit der Antwort „kann es nicht sagen“: die relative Differenz zweier Größen, unterhalb derer dies die Antwort ist; 0,1 ist eine Differenz von 10 %.</translation>
    </message>
    <message>
        <source>Model of a virtual participant&apos;s judgements.</source>
        <translation>Modell der Urteile einer virtuellen Versuchsperson.</translation>
    </message>
    <message>
        <source>Planned participants</source>
        <translation>Geplante Versuchspersonen</translation>
    </message>
    <message>
        <source>Planned number of participants.</source>
        <translation>Geplante Anzahl der Versuchspersonen.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Sessions per participant.</source>
        <translation>Sitzungen je Versuchsperson.</translation>
    </message>
    <message>
        <source>Questions asked once, before the first session.</source>
        <translation>Fragen, die einmal gestellt werden, vor der ersten Sitzung.</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Version of the consent text.</source>
        <translation>Version des Einwilligungstexts.</translation>
    </message>
    <message>
        <source>Statement</source>
        <translation>Erklärung</translation>
    </message>
    <message>
        <source>The text that the participant agrees to.</source>
        <translation>Der Text, dem die Versuchsperson zustimmt.</translation>
    </message>
    <message>
        <source>to the group with the fewest participants</source>
        <translation>in die Gruppe mit den wenigsten Versuchspersonen</translation>
    </message>
    <message>
        <source>by a random sequence in blocks, each of which contains every group equally often</source>
        <translation>nach einer Zufallsfolge in Blöcken, von denen jeder jede Gruppe gleich oft enthält</translation>
    </message>
    <message>
        <source>stated when the first session begins</source>
        <translation>zu Beginn der ersten Sitzung angegeben</translation>
    </message>
    <message>
        <source>The factor whose levels are the groups. Every trial has the level of the participant&apos;s group, so no block sets it.</source>
        <translation>Der Faktor, dessen Stufen die Gruppen sind. Jeder Durchgang hat die Stufe der Gruppe der Versuchsperson; deshalb legt kein Block sie fest.</translation>
    </message>
    <message>
        <source>Assignment</source>
        <translation>Zuteilung</translation>
    </message>
    <message>
        <source>The assignment of participants to groups.</source>
        <translation>Die Zuteilung der Versuchspersonen zu Gruppen.</translation>
    </message>
    <message>
        <source>Participants in a block.</source>
        <translation>Versuchspersonen in einem Block.</translation>
    </message>
    <message>
        <source>Sizes of blocks</source>
        <translation>Blockgrößen</translation>
    </message>
    <message>
        <source>Of permuted blocks: the sizes from which that of each block is drawn, multiples of the number of groups. Absent: two and three times this number.</source>
        <translation>Bei permutierten Blöcken: die Größen, aus denen die jedes Blocks gezogen wird, Vielfache der Anzahl der Gruppen. Ohne Angabe: das Zwei- und Dreifache dieser Anzahl.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Of permuted blocks: the seed of the sequence.</source>
        <translation>Bei permutierten Blöcken: der Startwert der Folge.</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>The texts that the participant reads. Default: the last text before the interruption.</source>
        <translation>Die Texte, die die Versuchsperson liest. Vorgabe: der letzte Text vor der Unterbrechung.</translation>
    </message>
    <message>
        <source>Maximum age without a reason</source>
        <translation>Höchstalter ohne Begründung</translation>
    </message>
    <message>
        <source>Time since the interruption after which a session is resumed only with a reason, which is stored.</source>
        <translation>Zeit seit der Unterbrechung, nach der eine Sitzung nur mit einer Begründung fortgesetzt wird, die gespeichert wird.</translation>
    </message>
    <message>
        <source>Repeated practice trials</source>
        <translation>Wiederholte Übung</translation>
    </message>
    <message>
        <source>Number of practice trials that the participant repeats before the session continues: the first trials of the latest practice block. They are stored as refreshers and never count.</source>
        <translation>Anzahl der Übungsdurchgänge, die die Versuchsperson vor der Fortsetzung der Sitzung wiederholt: die ersten Durchgänge des letzten Übungsblocks. Sie werden als Auffrischung gespeichert und zählen nie.</translation>
    </message>
    <message>
        <source>The participants.</source>
        <translation>Die Versuchspersonen.</translation>
    </message>
    <message>
        <source>Informed consent.</source>
        <translation>Einwilligung nach Aufklärung.</translation>
    </message>
    <message>
        <source>A between-participants factor: each participant belongs to one group, in all sessions of the protocol.</source>
        <translation>Ein Faktor zwischen Versuchspersonen: Jede Versuchsperson gehört in allen Sitzungen des Protokolls zu einer Gruppe.</translation>
    </message>
    <message>
        <source>Resumption of an interrupted session: the checks of the device are repeated, and the participant reads a text and then starts from a screen of the program.</source>
        <translation>Fortsetzung einer unterbrochenen Sitzung: Die Prüfungen des Geräts werden wiederholt, und die Versuchsperson liest einen Text und beginnt dann von einer Seite des Programms aus.</translation>
    </message>
    <message>
        <source>the order of the levels</source>
        <translation>die Reihenfolge der Stufen</translation>
    </message>
    <message>
        <source>a Latin square</source>
        <translation>ein lateinisches Quadrat</translation>
    </message>
    <message>
        <source>a Williams design</source>
        <translation>ein Williams-Design</translation>
    </message>
    <message>
        <source>this format</source>
        <translation>dieses Format</translation>
    </message>
    <message>
        <source>one response per participant and column of the published table</source>
        <translation>eine Antwort je Versuchsperson und Spalte der veröffentlichten Tabelle</translation>
    </message>
    <message>
        <source>balanced, with practice and repetitions</source>
        <translation>ausbalanciert, mit Übung und Wiederholungen</translation>
    </message>
    <message>
        <source>the texture&apos;s picture</source>
        <translation>das Bild der Textur</translation>
    </message>
    <message>
        <source>the coded sample</source>
        <translation>die mit einem Code versehene Probe</translation>
    </message>
    <message>
        <source>the participant&apos;s own idea of the material</source>
        <translation>die eigene Vorstellung der Versuchsperson vom Material</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name for citations.</source>
        <translation>Name für Zitate.</translation>
    </message>
    <message>
        <source>ORCID iD</source>
        <translation>ORCID iD</translation>
    </message>
    <message>
        <source>ORCID iD in four groups of four, such as 0000-0002-1825-0097.</source>
        <translation>ORCID iD in vier Gruppen zu vier Zeichen, zum Beispiel 0000-0002-1825-0097.</translation>
    </message>
    <message>
        <source>Affiliation</source>
        <translation>Zugehörigkeit</translation>
    </message>
    <message>
        <source>Institution of the author.</source>
        <translation>Institution der Autorin oder des Autors.</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>URI of this schema, for editors.</source>
        <translation>URI dieses Schemas, für Editoren.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The version of this format.</source>
        <translation>Die Version dieses Formats.</translation>
    </message>
    <message>
        <source>The design of the experiment.</source>
        <translation>Das Design des Experiments.</translation>
    </message>
    <message>
        <source>Short name, used in file names and data: lower-case letters, digits and underscores, starting with a letter.</source>
        <translation>Kurzer Name, in Dateinamen und Daten verwendet: Kleinbuchstaben, Ziffern und Unterstriche, mit einem Buchstaben beginnend.</translation>
    </message>
    <message>
        <source>Version of the protocol as three numbers, such as 1.0.0.</source>
        <translation>Version des Protokolls als drei Zahlen, zum Beispiel 1.0.0.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Title shown to users.</source>
        <translation>Titel für die Anzeige im Programm.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Language of the protocol&apos;s texts, and of the program&apos;s own texts to the participant, as a BCP 47 tag: &quot;en&quot;, &quot;de&quot;. The program has English and German; in any other language its own texts are English.</source>
        <translation>Sprache der Texte des Protokolls und der programmeigenen Texte für die Versuchsperson, als BCP-47-Kennung: „en“, „de“. Das Programm kann Englisch und Deutsch; in jeder anderen Sprache sind seine eigenen Texte englisch.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Question and method of the study.</source>
        <translation>Frage und Methode der Studie.</translation>
    </message>
    <message>
        <source>Authors</source>
        <translation>Autorinnen und Autoren</translation>
    </message>
    <message>
        <source>Authors of this protocol.</source>
        <translation>Autorinnen und Autoren dieses Protokolls.</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Licence of this protocol, such as CC-BY-4.0.</source>
        <translation>Lizenz dieses Protokolls, zum Beispiel CC-BY-4.0.</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Standard of realism</source>
        <translation>Maßstab des Realismus</translation>
    </message>
    <message>
        <source>Selection, paired comparison: the standard with which realism is compared.</source>
        <translation>Auswahl, Paarvergleich: der Maßstab, mit dem der Realismus verglichen wird.</translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Instability</source>
        <translation>Instabilität</translation>
    </message>
    <message>
        <source>Haptic device</source>
        <translation>Haptisches Gerät</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>The textures by name.</source>
        <translation>Die Texturen nach Namen.</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Solid bodies by name, for models in which a tool touches a surface.</source>
        <translation>Feste Körper nach Namen, für Modelle, bei denen ein Werkzeug eine Oberfläche berührt.</translation>
    </message>
    <message>
        <source>Stimuli</source>
        <translation>Reize</translation>
    </message>
    <message>
        <source>The stimuli by name.</source>
        <translation>Die Reize nach Namen.</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>The factors by name.</source>
        <translation>Die Faktoren nach Namen.</translation>
    </message>
    <message>
        <source>Explorations</source>
        <translation>Explorationen</translation>
    </message>
    <message>
        <source>Ways to explore a surface, by name.</source>
        <translation>Arten, eine Oberfläche zu explorieren, nach Namen.</translation>
    </message>
    <message>
        <source>Questions of the questionnaire and about the participant, by name.</source>
        <translation>Fragen des Fragebogens und zur Versuchsperson, nach Namen.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Blocks of trials, by name.</source>
        <translation>Blöcke von Durchgängen, nach Namen.</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Ablauf</translation>
    </message>
    <message>
        <source>The session, step by step.</source>
        <translation>Die Sitzung, Schritt für Schritt.</translation>
    </message>
    <message>
        <source>Resumption</source>
        <translation>Fortsetzung</translation>
    </message>
    <message>
        <source>Counterbalancing</source>
        <translation>Ausbalancierung</translation>
    </message>
    <message>
        <source>Order, across participants, of the levels of a factor for each of which a block is run.</source>
        <translation>Reihenfolge der Stufen eines Faktors, für deren jede ein Block läuft, über die Versuchspersonen.</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Virtual observer</source>
        <translation>Virtuelle Versuchsperson</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>An author of this protocol.</source>
        <translation>Eine Autorin oder ein Autor dieses Protokolls.</translation>
    </message>
    <message>
        <source>A haptic texture experiment: its stimuli, their order, and its questions.</source>
        <translation>Ein Experiment mit haptischen Texturen: seine Reize, ihre Reihenfolge und seine Fragen.</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>The value that is stored and exported: the same in all languages of a protocol.</source>
        <translation>Der Wert, der gespeichert und exportiert wird: in allen Sprachen eines Protokolls derselbe.</translation>
    </message>
    <message>
        <source>The text that is shown for this option.</source>
        <translation>Der Text, der für diese Antwort gezeigt wird.</translation>
    </message>
    <message>
        <source>one of the options</source>
        <translation>eine der Antworten</translation>
    </message>
    <message>
        <source>one or more of the options</source>
        <translation>eine oder mehrere der Antworten</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a point on a scale</source>
        <translation>ein Punkt auf einer Skala</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>Text of the question.</source>
        <translation>Text der Frage.</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>An option: the text that is shown and stored, or a stored value and another text that is shown, for example in another language.</source>
        <translation>Eine Antwortmöglichkeit: der Text, der gezeigt und gespeichert wird, oder ein gespeicherter Wert und ein anderer Text, der gezeigt wird, zum Beispiel in einer anderen Sprache.</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Antwortmöglichkeiten</translation>
    </message>
    <message>
        <source>The options of a choice or a multiple choice.</source>
        <translation>Die Antwortmöglichkeiten einer einfachen oder einer Mehrfachauswahl.</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>Smallest number accepted.</source>
        <translation>Kleinste zulässige Zahl.</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Largest number accepted.</source>
        <translation>Größte zulässige Zahl.</translation>
    </message>
    <message>
        <source>Unit of the number, shown next to it and exported.</source>
        <translation>Einheit der Zahl, neben ihr gezeigt und exportiert.</translation>
    </message>
    <message>
        <source>Only if</source>
        <translation>Nur wenn</translation>
    </message>
    <message>
        <source>The condition under which the question is asked.</source>
        <translation>Die Bedingung, unter der die Frage gestellt wird.</translation>
    </message>
    <message>
        <source>Optional</source>
        <translation>Freiwillig</translation>
    </message>
    <message>
        <source>Whether the question may be left unanswered.</source>
        <translation>Ob die Frage unbeantwortet bleiben darf.</translation>
    </message>
    <message>
        <source>Left end</source>
        <translation>Linkes Ende</translation>
    </message>
    <message>
        <source>The value at the left end.</source>
        <translation>Der Wert am linken Ende.</translation>
    </message>
    <message>
        <source>Right end</source>
        <translation>Rechtes Ende</translation>
    </message>
    <message>
        <source>The value at the right end.</source>
        <translation>Der Wert am rechten Ende.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Number of equally spaced points, both ends included; absent: every position of the line is a response.</source>
        <translation>Anzahl der Punkte in gleichen Abständen, einschließlich beider Enden; ohne Angabe: jede Stelle der Linie ist eine Antwort.</translation>
    </message>
    <message>
        <source>One label.</source>
        <translation>Eine Beschriftung.</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message>
        <source>Labels of the two ends, or one for every point; absent: none.</source>
        <translation>Beschriftungen der beiden Enden oder eine für jeden Punkt; ohne Angabe: keine.</translation>
    </message>
    <message>
        <source>The question, which the flow asks earlier.</source>
        <translation>Die Frage, die der Ablauf früher stellt.</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>The answer: an option, or a number.</source>
        <translation>Die Antwort: eine Antwortmöglichkeit oder eine Zahl.</translation>
    </message>
    <message>
        <source>One possible answer: an option, or a number.</source>
        <translation>Eine mögliche Antwort: eine Antwortmöglichkeit oder eine Zahl.</translation>
    </message>
    <message>
        <source>One of</source>
        <translation>Eine von</translation>
    </message>
    <message>
        <source>Several possible answers.</source>
        <translation>Mehrere mögliche Antworten.</translation>
    </message>
    <message>
        <source>Includes</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>An option that is among those chosen in a multiple choice.</source>
        <translation>Eine Antwortmöglichkeit unter den bei einer Mehrfachauswahl gewählten.</translation>
    </message>
    <message>
        <source>Smallest answer, of a number or a scale.</source>
        <translation>Kleinste Antwort, bei einer Zahl oder einer Skala.</translation>
    </message>
    <message>
        <source>Largest answer, of a number or a scale.</source>
        <translation>Größte Antwort, bei einer Zahl oder einer Skala.</translation>
    </message>
    <message>
        <source>A question of the questionnaire, or about the participant.</source>
        <translation>Eine Frage des Fragebogens oder zur Versuchsperson.</translation>
    </message>
    <message>
        <source>An option whose text differs from its stored value.</source>
        <translation>Eine Antwortmöglichkeit, deren Text von ihrem gespeicherten Wert abweicht.</translation>
    </message>
    <message>
        <source>A scale on which the response is a point: with labelled points (Likert), with labelled ends (semantic differential), or a line without points (visual analogue scale).</source>
        <translation>Eine Skala, auf der die Antwort ein Punkt ist: mit beschrifteten Punkten (Likert), mit beschrifteten Enden (semantisches Differenzial) oder eine Linie ohne Punkte (visuelle Analogskala).</translation>
    </message>
    <message>
        <source>The answer to an earlier question of the questionnaire on which a question or a screen depends. Exactly one of an answer, several possible answers, an answer among those chosen, or a range.</source>
        <translation>Die Antwort auf eine frühere Frage des Fragebogens, von der eine Frage oder ein Text abhängt. Genau eines von einer Antwort, mehreren möglichen Antworten, einer Antwort unter den gewählten oder einem Bereich.</translation>
    </message>
    <message>
        <source>Record every tick</source>
        <translation>Jeden Takt aufzeichnen</translation>
    </message>
    <message>
        <source>Whether all ticks of all attempts are recorded.</source>
        <translation>Ob alle Takte aller Versuche aufgezeichnet werden.</translation>
    </message>
    <message>
        <source>the attempt is flagged</source>
        <translation>der Versuch wird markiert</translation>
    </message>
    <message>
        <source>the attempt is repeated at once</source>
        <translation>der Versuch wird sofort wiederholt</translation>
    </message>
    <message>
        <source>Greatest vibration</source>
        <translation>Stärkste Vibration</translation>
    </message>
    <message>
        <source>Greatest vibration of a surface above 150 Hz, relative to its texture force.</source>
        <translation>Stärkste Vibration einer Oberfläche über 150 Hz, relativ zu ihrer Texturkraft.</translation>
    </message>
    <message>
        <source>Consequence</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>An attempt with more vibration is flagged, or repeated at once: twice at most, after which it is flagged.</source>
        <translation>Ein Versuch mit mehr Vibration wird markiert oder sofort wiederholt: höchstens zweimal, danach wird er markiert.</translation>
    </message>
    <message>
        <source>the height outside is that of the border</source>
        <translation>außerhalb gilt die Höhe des Rands</translation>
    </message>
    <message>
        <source>repeated</source>
        <translation>wiederholt</translation>
    </message>
    <message>
        <source>repeated, every other copy mirrored</source>
        <translation>wiederholt, jede zweite Kopie gespiegelt</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>eine Wand</translation>
    </message>
    <message>
        <source>a fading force</source>
        <translation>eine abnehmende Kraft</translation>
    </message>
    <message>
        <source>A coordinate.</source>
        <translation>Eine Koordinate.</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Centre of the patch in the device&apos;s frame: x, y, z.</source>
        <translation>Mitte des Felds im Koordinatensystem des Geräts: x, y, z.</translation>
    </message>
    <message>
        <source>An extent.</source>
        <translation>Eine Ausdehnung.</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Extent of the patch along x and y.</source>
        <translation>Ausdehnung des Felds entlang x und y.</translation>
    </message>
    <message>
        <source>Beyond the height field</source>
        <translation>Jenseits des Höhenfelds</translation>
    </message>
    <message>
        <source>Continuation of the height field beyond its border.</source>
        <translation>Fortsetzung des Höhenfelds jenseits seines Rands.</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>The border of the patch: a wall, or a fading force. A wall acts in contact, from the place where contact began.</source>
        <translation>Der Rand des Felds: eine Wand oder eine abnehmende Kraft. Eine Wand wirkt im Kontakt, von der Stelle aus, an der er begann.</translation>
    </message>
    <message>
        <source>Width of the border</source>
        <translation>Breite des Rands</translation>
    </message>
    <message>
        <source>Width of the border over which the force fades.</source>
        <translation>Breite des Rands, über die die Kraft abnimmt.</translation>
    </message>
    <message>
        <source>Scale of motion</source>
        <translation>Bewegungsmaßstab</translation>
    </message>
    <message>
        <source>Ratio of motion on the surface to motion of the hand.</source>
        <translation>Verhältnis der Bewegung auf der Oberfläche zur Bewegung der Hand.</translation>
    </message>
    <message>
        <source>Stiffness normal to the surface.</source>
        <translation>Steifigkeit senkrecht zur Oberfläche.</translation>
    </message>
    <message>
        <source>Coulomb friction coefficient.</source>
        <translation>Coulomb-Reibungskoeffizient.</translation>
    </message>
    <message>
        <source>The recorded data.</source>
        <translation>Die aufgezeichneten Daten.</translation>
    </message>
    <message>
        <source>Consequence of a vibration that the force model does not contain. The vibration of every surface is stored, with or without a consequence.</source>
        <translation>Folge einer Vibration, die das Kraftmodell nicht enthält. Die Vibration jeder Oberfläche wird gespeichert, mit und ohne Folge.</translation>
    </message>
    <message>
        <source>The patch of the workspace in which textures are felt.</source>
        <translation>Das Feld des Arbeitsraums, in dem Texturen gefühlt werden.</translation>
    </message>
    <message>
        <source>Stiffness and friction of every surface, without its texture.</source>
        <translation>Steifigkeit und Reibung jeder Oberfläche, ohne ihre Textur.</translation>
    </message>
    <message>
        <source>A name: lower-case letters, digits and underscores, starting with a letter.</source>
        <translation>Ein Name: Kleinbuchstaben, Ziffern und Unterstriche, mit einem Buchstaben beginnend.</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>Target RMS of the texture force.</source>
        <translation>Angestrebter Effektivwert der Texturkraft.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The model whose texture force is the target.</source>
        <translation>Das Modell, dessen Texturkraft angestrebt wird.</translation>
    </message>
    <message>
        <source>Lower limit of the band</source>
        <translation>Untere Bandgrenze</translation>
    </message>
    <message>
        <source>Lower limit of the band in which the RMS is computed.</source>
        <translation>Untere Grenze des Frequenzbands, in dem der Effektivwert berechnet wird.</translation>
    </message>
    <message>
        <source>Upper limit of the band</source>
        <translation>Obere Bandgrenze</translation>
    </message>
    <message>
        <source>Upper limit of the band in which the RMS is computed.</source>
        <translation>Obere Grenze des Frequenzbands, in dem der Effektivwert berechnet wird.</translation>
    </message>
    <message>
        <source>Force model</source>
        <translation>Kraftmodell</translation>
    </message>
    <message>
        <source>A force model, or the factor whose level it is.</source>
        <translation>Ein Kraftmodell oder der Faktor, dessen Stufe es ist.</translation>
    </message>
    <message>
        <source>A texture, or the factor whose level it is.</source>
        <translation>Eine Textur oder der Faktor, dessen Stufe sie ist.</translation>
    </message>
    <message>
        <source>The body that is touched: by the tool of a model that requires bodies, or by the point of any other model, in place of the plane.</source>
        <translation>Der Körper, der berührt wird: vom Werkzeug eines Modells, das Körper erfordert, oder vom Punkt jedes anderen Modells, anstelle der Ebene.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>The body in the hand, for a model that requires bodies.</source>
        <translation>Der Körper in der Hand, für ein Modell, das Körper erfordert.</translation>
    </message>
    <message>
        <source>A value, or the factor whose level it is.</source>
        <translation>Ein Wert oder der Faktor, dessen Stufe er ist.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Parameters of the force model by name (see `asperity models`); a missing parameter has the value that the height field of the texture suggests, and without a suggestion the model&apos;s default.</source>
        <translation>Parameter des Kraftmodells nach Namen (siehe `asperity models`); ein fehlender Parameter hat den Wert, den das Höhenfeld der Textur nahelegt, und sonst die Vorgabe des Modells.</translation>
    </message>
    <message>
        <source>Equal force</source>
        <translation>Gleiche Kraft</translation>
    </message>
    <message>
        <source>A force model with a texture and parameters, each of which can be bound to a factor.</source>
        <translation>Ein Kraftmodell mit einer Textur und Parametern, die jeweils an einen Faktor gebunden werden können.</translation>
    </message>
    <message>
        <source>Determines the model&apos;s amplitude parameter so that the RMS texture force equals a stated value or that of another model with the same texture.</source>
        <translation>Bestimmt den Amplitudenparameter des Modells so, dass der Effektivwert der Texturkraft einem angegebenen Wert oder dem eines anderen Modells mit derselben Textur gleicht.</translation>
    </message>
    <message>
        <source>Stiffness and friction of this stimulus, in place of those of the protocol&apos;s material.</source>
        <translation>Steifigkeit und Reibung dieses Reizes, anstelle derer des Materials des Protokolls.</translation>
    </message>
    <message>
        <source>ln(band RMS / mean normal force).</source>
        <translation>ln(Effektivwert im Band / mittlere Normalkraft).</translation>
    </message>
    <message>
        <source>Ten numbers: ln(band RMS / mean normal force), longest wavelength first.</source>
        <translation>Zehn Zahlen: ln(Effektivwert im Band / mittlere Normalkraft), die längste Wellenlänge zuerst.</translation>
    </message>
    <message>
        <source>ln(RMS of the texture force / mean normal force).</source>
        <translation>ln(Effektivwert der Texturkraft / mittlere Normalkraft).</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>ln(RMS of the lateral force in all bands together / mean normal force).</source>
        <translation>ln(Effektivwert der Seitenkraft in allen Bändern zusammen / mittlere Normalkraft).</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Name of the texture for blinded experimenters, for example the label on a physical sample.</source>
        <translation>Name der Textur für eine verblindete Versuchsleitung, zum Beispiel die Beschriftung einer physischen Probe.</translation>
    </message>
    <message>
        <source>Height field</source>
        <translation>Höhenfeld</translation>
    </message>
    <message>
        <source>Height field that is rendered (a PNG with its sidecar); absent: no rendered counterpart.</source>
        <translation>Höhenfeld, das wiedergegeben wird (ein PNG mit Begleitdatei); ohne Angabe: keine Wiedergabe.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture that is shown.</source>
        <translation>Bild, das gezeigt wird.</translation>
    </message>
    <message>
        <source>True height field</source>
        <translation>Wahres Höhenfeld</translation>
    </message>
    <message>
        <source>The true heights of a procedural texture, for virtual participants.</source>
        <translation>Die wahren Höhen einer prozeduralen Textur, für virtuelle Versuchspersonen.</translation>
    </message>
    <message>
        <source>Further files</source>
        <translation>Weitere Dateien</translation>
    </message>
    <message>
        <source>Further files that force models need: role → file, relative to the study. The models declare the roles (see `asperity models`): `recording` of the model `recorded`, `vibration_models` of `data_driven`.</source>
        <translation>Weitere Dateien, die Kraftmodelle benötigen: Rolle → Datei, relativ zur Studie. Die Modelle legen die Rollen fest (siehe `asperity models`): `recording` beim Modell `recorded`, `vibration_models` bei `data_driven`.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Spacing of the texture: the distance between its elements, for the analysis of estimates.</source>
        <translation>Abstand der Elemente der Textur, für die Auswertung von Schätzungen.</translation>
    </message>
    <message>
        <source>Expected features</source>
        <translation>Erwartete Merkmale</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Further information for readers of the data, for example an assumed width.</source>
        <translation>Weitere Angaben für alle, die die Daten lesen, zum Beispiel eine angenommene Breite.</translation>
    </message>
    <message>
        <source>A texture of the experiment: felt (a height field), seen (a picture), or both.</source>
        <translation>Eine Textur des Experiments: gefühlt (ein Höhenfeld), gesehen (ein Bild) oder beides.</translation>
    </message>
    <message>
        <source>Expected force features of the texture, as natural logarithms (see &quot;Definitions of the features&quot; in docs/formats/protocol.md).</source>
        <translation>Erwartete Kraftmerkmale der Textur, als natürliche Logarithmen (siehe „Definitions of the features“ in docs/formats/protocol.md).</translation>
    </message>
    <message>
        <source>Longest line</source>
        <translation>Längste Linie</translation>
    </message>
    <message>
        <source>The longest line, as a proportion of the width of the screen.</source>
        <translation>Die längste Linie, als Anteil der Breite des Bildschirms.</translation>
    </message>
    <message>
        <source>the comparison is the correct response</source>
        <translation>der Vergleichsreiz ist die richtige Antwort</translation>
    </message>
    <message>
        <source>no response is correct, and the point of subjective equality is estimated</source>
        <translation>keine Antwort ist richtig, und der Punkt der subjektiven Gleichheit wird geschätzt</translation>
    </message>
    <message>
        <source>the higher value</source>
        <translation>der höhere Wert</translation>
    </message>
    <message>
        <source>the lower value</source>
        <translation>der niedrigere Wert</translation>
    </message>
    <message>
        <source>the dissimilarity of the two surfaces</source>
        <translation>die Unähnlichkeit der beiden Oberflächen</translation>
    </message>
    <message>
        <source>the similarity of the two surfaces</source>
        <translation>die Ähnlichkeit der beiden Oberflächen</translation>
    </message>
    <message>
        <source>Name of the response in the data.</source>
        <translation>Name der Antwort in den Daten.</translation>
    </message>
    <message>
        <source>The question as the participant reads it.</source>
        <translation>Die Frage, wie die Versuchsperson sie liest.</translation>
    </message>
    <message>
        <source>Textures whose pictures are the options; absent: the surfaces felt are the options.</source>
        <translation>Texturen, deren Bilder die Antwortmöglichkeiten sind; ohne Angabe: die gefühlten Oberflächen.</translation>
    </message>
    <message>
        <source>Draw positions in every trial</source>
        <translation>Positionen neu auslosen</translation>
    </message>
    <message>
        <source>Whether the positions of the pictures are drawn for every trial; otherwise they are drawn once per session.</source>
        <translation>Ob die Positionen der Bilder für jeden Durchgang ausgelost werden; sonst einmal je Sitzung.</translation>
    </message>
    <message>
        <source>&quot;I cannot tell&quot;</source>
        <translation>„Kann es nicht sagen“</translation>
    </message>
    <message>
        <source>Whether &quot;I cannot tell&quot; is one of the options. In a discrimination in which one of two surfaces is chosen, such a response counts as the mean of a guess.</source>
        <translation>Ob „kann es nicht sagen“ eine der Antwortmöglichkeiten ist. Bei einer Unterscheidung, in der eine von zwei Oberflächen gewählt wird, zählt eine solche Antwort wie das Mittel des Ratens.</translation>
    </message>
    <message>
        <source>Factor of the correct answer</source>
        <translation>Faktor der richtigen Antwort</translation>
    </message>
    <message>
        <source>The factor whose level is the correct picture or option.</source>
        <translation>Der Faktor, dessen Stufe das richtige Bild oder die richtige Option ist.</translation>
    </message>
    <message>
        <source>Judgement</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Discrimination: whether a response can be correct.</source>
        <translation>Unterscheidung: ob eine Antwort richtig sein kann.</translation>
    </message>
    <message>
        <source>Asks for</source>
        <translation>Gefragter Wert</translation>
    </message>
    <message>
        <source>Discrimination with the judgement comparison: whether the question asks for the surface with the higher or the lower value of the varied parameter.</source>
        <translation>Unterscheidung mit dem Urteil comparison: ob nach der Oberfläche mit dem höheren oder dem niedrigeren Wert des variierten Parameters gefragt wird.</translation>
    </message>
    <message>
        <source>Confidence of</source>
        <translation>Sicherheit bei</translation>
    </message>
    <message>
        <source>Of a scale in a block of a discrimination: the earlier question whose response it rates the confidence of.</source>
        <translation>Bei einer Skala in einem Block einer Unterscheidung: die frühere Frage, für deren Antwort sie die Sicherheit beurteilt.</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Beurteilte Größe</translation>
    </message>
    <message>
        <source>Similarity: whether the scale increases with the dissimilarity or with the similarity of the two surfaces.</source>
        <translation>Ähnlichkeit: ob die Skala mit der Unähnlichkeit oder mit der Ähnlichkeit der beiden Oberflächen zunimmt.</translation>
    </message>
    <message>
        <source>Tie</source>
        <translation>Gleichstand</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Text for the experimenter; {code} is replaced by the code of the trial&apos;s texture.</source>
        <translation>Text für die Versuchsleitung; {code} wird durch den Code der Textur des Durchgangs ersetzt.</translation>
    </message>
    <message>
        <source>Whether pictures stay hidden until every surface has been felt.</source>
        <translation>Ob Bilder verborgen bleiben, bis jede Oberfläche gefühlt wurde.</translation>
    </message>
    <message>
        <source>Whether the participant may switch between the surfaces before responding.</source>
        <translation>Ob die Versuchsperson vor der Antwort zwischen den Oberflächen wechseln kann.</translation>
    </message>
    <message>
        <source>One of several questions of a trial.</source>
        <translation>Eine von mehreren Fragen eines Durchgangs.</translation>
    </message>
    <message>
        <source>The question of every trial, if there is only one.</source>
        <translation>Die Frage jedes Durchgangs, wenn es nur eine gibt.</translation>
    </message>
    <message>
        <source>One option: the value that is stored, and the text that is shown.</source>
        <translation>Eine Antwortmöglichkeit: der Wert, der gespeichert wird, und der Text, der gezeigt wird.</translation>
    </message>
    <message>
        <source>Paired comparison: an option after those for the surfaces, stored as &quot;tie&quot;; absent: one of the surfaces has to be chosen.</source>
        <translation>Paarvergleich: eine Antwortmöglichkeit nach denen für die Oberflächen, als „tie“ gespeichert; ohne Angabe: eine der Oberflächen muss gewählt werden.</translation>
    </message>
    <message>
        <source>Shortest interval</source>
        <translation>Kürzestes Intervall</translation>
    </message>
    <message>
        <source>Longest interval</source>
        <translation>Längstes Intervall</translation>
    </message>
    <message>
        <source>99th percentile of lateness</source>
        <translation>99. Perzentil der Verspätung</translation>
    </message>
    <message>
        <source>Maximum age of the profile</source>
        <translation>Höchstalter des Profils</translation>
    </message>
    <message>
        <source>Refuse unsuitable devices</source>
        <translation>Ungeeignete Geräte ablehnen</translation>
    </message>
    <message>
        <source>Request at reference point</source>
        <translation>Aufforderung am Bezugspunkt</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Niedrigster Wert</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Höchster Wert</translation>
    </message>
    <message>
        <source>Presentation</source>
        <translation>Darbietung</translation>
    </message>
    <message>
        <source>Sound level</source>
        <translation>Schallpegel</translation>
    </message>
    <message>
        <source>Starting level</source>
        <translation>Startstufe</translation>
    </message>
    <message>
        <source>Target proportion</source>
        <translation>Zielanteil</translation>
    </message>
    <message>
        <source>What the experiment asks, and how the protocol is cited.</source>
        <translation>Was das Experiment fragt, und wie das Protokoll zitiert wird.</translation>
    </message>
    <message>
        <source>What is felt, and in what the surfaces differ.</source>
        <translation>Was gefühlt wird, und worin sich die Oberflächen unterscheiden.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>What participants do in a trial, and how they explore a surface.</source>
        <translation>Was Versuchspersonen in einem Durchgang tun, und wie sie eine Oberfläche erkunden.</translation>
    </message>
    <message>
        <source>Order and groups</source>
        <translation>Reihenfolge und Gruppen</translation>
    </message>
    <message>
        <source>The course of a session, the trials of its blocks, and the groups of participants.</source>
        <translation>Der Ablauf einer Sitzung, die Durchgänge ihrer Blöcke und die Gruppen der Versuchspersonen.</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Versuchsperson</translation>
    </message>
    <message>
        <source>Who takes part, what is asked of a participant, and what can be seen and heard.</source>
        <translation>Wer teilnimmt, was eine Versuchsperson gefragt wird, und was zu sehen und zu hören ist.</translation>
    </message>
    <message>
        <source>The texts that participants read, in the order of the file.</source>
        <translation>Die Texte, die Versuchspersonen lesen, in der Reihenfolge der Datei.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>The device, its limits, and what is recorded.</source>
        <translation>Das Gerät, seine Grenzen und was aufgezeichnet wird.</translation>
    </message>
    <message>
        <source>Virtual participants</source>
        <translation>Virtuelle Versuchspersonen</translation>
    </message>
    <message>
        <source>How simulated participants respond.</source>
        <translation>Wie simulierte Versuchspersonen antworten.</translation>
    </message>
    <message>
        <source>The tests and measures that were decided before the data exist.</source>
        <translation>Die Tests und Maße, die festgelegt wurden, bevor Daten vorliegen.</translation>
    </message>
    <message>
        <source>The question, which the trial asks earlier.</source>
        <translation>Die Frage, die der Durchgang früher stellt.</translation>
    </message>
    <message>
        <source>The answer to an earlier question of the same trial on which a question depends. Exactly one of an answer, several possible answers, an answer among those chosen, or a range.</source>
        <translation>Die Antwort auf eine frühere Frage desselben Durchgangs, von der eine Frage abhängt. Genau eines von einer Antwort, mehreren möglichen Antworten, einer Antwort unter den gewählten oder einem Bereich.</translation>
    </message>
    <message>
        <source>the length of a line</source>
        <translation>die Länge einer Linie</translation>
    </message>
    <message>
        <source>Form of the response.</source>
        <translation>Form der Antwort.</translation>
    </message>
    <message>
        <source>The response is the length of a line that the participant draws, for a magnitude in place of a number. It is stored as a proportion of the width of the participant&apos;s screen.</source>
        <translation>Die Antwort ist die Länge einer Linie, die die Versuchsperson zeichnet, bei einer Größenschätzung an Stelle einer Zahl. Sie wird als Anteil an der Breite des Bildschirms der Versuchsperson gespeichert.</translation>
    </message>
    <message>
        <source>Form of the response to an additional question, which is stored and exported and which no analysis uses, except that of a scale. Absent: the question of the kind of experiment, or one answered on a scale.</source>
        <translation>Form der Antwort auf eine zusätzliche Frage, die gespeichert und exportiert wird und die außer bei einer Skala keine Auswertung verwendet. Ohne Angabe: die Frage der Art des Experiments, oder eine, die auf einer Skala beantwortet wird.</translation>
    </message>
    <message>
        <source>Options in words, in the order in which they are shown; only for kinds of experiment that permit them, and for an additional question.</source>
        <translation>Optionen in Worten, in der Reihenfolge der Anzeige; nur für Arten von Experimenten, die sie erlauben, und für eine zusätzliche Frage.</translation>
    </message>
    <message>
        <source>Tests whose p values are Holm-corrected together: the confirmatory tests of the study. All others are exploratory. Reports compare women and men only if the test of the sexes is listed. Absent: the first test of the kind; of estimates by another factor than spacings, that of the exponent, or of the stimuli without a predictor.</source>
        <translation>Tests, deren p-Werte gemeinsam Holm-korrigiert werden: die konfirmatorischen Tests der Studie. Alle anderen sind explorativ. Berichte vergleichen Frauen und Männer nur, wenn der Test der Geschlechter aufgeführt ist. Ohne Angabe: der erste Test der Art; bei Schätzungen nach einem anderen Faktor als Abständen der des Exponenten, oder der Reize ohne Prädiktor.</translation>
    </message>
    <message>
        <source>The kind of experiment; a block can have another one.</source>
        <translation>Die Art des Experiments; ein Block kann eine andere haben.</translation>
    </message>
    <message>
        <source>Discrimination and paired comparison: whether the magnitude increases or decreases with the parameter.</source>
        <translation>Unterscheidung und Paarvergleich: ob die Größe mit dem Parameter zunimmt oder abnimmt.</translation>
    </message>
    <message>
        <source>Magnitude and rating: exponent of the power function from the judged quantity to the estimate.</source>
        <translation>Größenschätzung und Beurteilung: Exponent der Potenzfunktion von der beurteilten Größe zur Schätzung.</translation>
    </message>
</context>
<context>
    <name>LabelNotice</name>
    <message>
        <source>on a simulated clock</source>
        <translation>mit simulierter Uhr</translation>
    </message>
    <message>
        <source>virtual participant</source>
        <translation>virtuelle Versuchsperson</translation>
    </message>
    <message>
        <source>added %1</source>
        <translation>hinzugefügt %1</translation>
    </message>
    <message>
        <source>study data</source>
        <translation>Studiendaten</translation>
    </message>
    <message>
        <source>pilot data</source>
        <translation>Pilotdaten</translation>
    </message>
    <message>
        <source>simulated data</source>
        <translation>simulierte Daten</translation>
    </message>
    <message>
        <source>If %1 is meant, use that label.</source>
        <translation>Falls %1 gemeint ist, dieses Kürzel verwenden.</translation>
    </message>
    <message>
        <source>%1, version %2, %3</source>
        <translation>%1, Version %2, %3</translation>
    </message>
    <message>
        <source>%1 has completed session %2 of this protocol (%3); a further session begins</source>
        <translation>%1 hat Sitzung %2 dieses Protokolls abgeschlossen (%3); eine weitere beginnt</translation>
    </message>
    <message>
        <source>For another participant, use another label.</source>
        <translation>Für eine andere Versuchsperson ein anderes Kürzel verwenden.</translation>
    </message>
    <message>
        <source>session %2 of %1 with this protocol is unfinished (%3); a further session begins</source>
        <translation>Sitzung %2 von %1 mit diesem Protokoll ist unvollständig (%3); eine weitere beginnt</translation>
    </message>
    <message>
        <source>Resume it, or use another label.</source>
        <translation>Die Sitzung fortsetzen oder ein anderes Kürzel verwenden.</translation>
    </message>
    <message>
        <source>To resume it, choose the protocol file with which the session began.</source>
        <translation>Zum Fortsetzen das Protokoll in der Fassung wählen, mit der die Sitzung begann.</translation>
    </message>
    <message>
        <source>%1 has completed %2 of %3 planned sessions of this protocol, the latest %4</source>
        <translation>%1 hat %2 von %3 geplanten Sitzungen dieses Protokolls abgeschlossen, die letzte %4</translation>
    </message>
    <message>
        <source>%1 is a new participant; %2, whose label differs only in letter case or leading zeros, is in the study already (%3)</source>
        <translation>%1 ist eine neue Versuchsperson; %2 ist schon in der Studie (%3), und das Kürzel unterscheidet sich nur in der Groß- und Kleinschreibung oder in führenden Nullen</translation>
    </message>
</context>
<context>
    <name>MissingThreshold</name>
    <message>
        <source>every response is correct: the threshold is below the presented levels; present smaller differences</source>
        <translation>jede Antwort ist richtig: Die Schwelle liegt unter den dargebotenen Stufen; kleinere Differenzen darbieten</translation>
    </message>
    <message>
        <source>no response is correct: check the question and its correct response</source>
        <translation>keine Antwort ist richtig: die Frage und ihre richtige Antwort prüfen</translation>
    </message>
    <message>
        <source>the proportion correct does not increase with the difference from the standard, as if the responses were guesses: check the responses in the practice and in catch trials before you present other levels</source>
        <translation>der Anteil richtiger Antworten nimmt mit der Differenz zum Standardreiz nicht zu, als wären die Antworten geraten: die Antworten in der Übung und in den Kontrolldurchgängen prüfen, bevor andere Stufen dargeboten werden</translation>
    </message>
    <message>
        <source>every response is the one of high levels: the point of subjective equality is below the presented levels; present lower levels</source>
        <translation>jede Antwort ist die hoher Stufen: Der Punkt subjektiver Gleichheit liegt unter den dargebotenen Stufen; niedrigere Stufen darbieten</translation>
    </message>
    <message>
        <source>every response is the one of low levels: the point of subjective equality is above the presented levels; present higher levels</source>
        <translation>jede Antwort ist die niedriger Stufen: Der Punkt subjektiver Gleichheit liegt über den dargebotenen Stufen; höhere Stufen darbieten</translation>
    </message>
    <message>
        <source>the proportion of hits does not increase with the level, as if the responses were guesses: check the responses in the practice and in catch trials before you present other levels</source>
        <translation>der Anteil der Treffer nimmt mit der Stufe nicht zu, als wären die Antworten geraten: die Antworten in der Übung und in den Kontrolldurchgängen prüfen, bevor andere Stufen dargeboten werden</translation>
    </message>
    <message>
        <source>the threshold is above the presented levels: present larger differences</source>
        <translation>die Schwelle liegt über den dargebotenen Stufen: größere Differenzen darbieten</translation>
    </message>
    <message>
        <source>the threshold is below the presented levels: present smaller differences</source>
        <translation>die Schwelle liegt unter den dargebotenen Stufen: kleinere Differenzen darbieten</translation>
    </message>
    <message>
        <source>the point of subjective equality is outside the presented levels: present levels on both sides of it</source>
        <translation>der Punkt subjektiver Gleichheit liegt außerhalb der dargebotenen Stufen: Stufen auf beiden Seiten davon darbieten</translation>
    </message>
    <message>
        <source>the values at 25 % and 75 % are not both within the presented levels: present a wider range of levels</source>
        <translation>die Werte bei 25 % und 75 % liegen nicht beide innerhalb der dargebotenen Stufen: einen größeren Bereich von Stufen darbieten</translation>
    </message>
    <message>
        <source>the function is steeper than the presented levels can resolve: present levels nearer to the threshold</source>
        <translation>die Funktion ist steiler, als die dargebotenen Stufen auflösen: Stufen näher an der Schwelle darbieten</translation>
    </message>
    <message>
        <source>the slope is at a limit of the fit, because the responses do not determine it: add trials</source>
        <translation>die Steigung liegt an einer Grenze der Anpassung, weil die Antworten sie nicht bestimmen: Durchgänge ergänzen</translation>
    </message>
    <message>
        <source>more than 5 % of the posterior probability is at an end of the range of thresholds of the prior: widen the range, and present levels in it</source>
        <translation>mehr als 5 % der A-posteriori-Wahrscheinlichkeit liegen an einem Ende des Schwellenbereichs der A-priori-Verteilung: den Bereich erweitern und Stufen darin darbieten</translation>
    </message>
    <message>
        <source>no threshold is defined for these data: add trials at several levels</source>
        <translation>für diese Daten ist keine Schwelle definiert: Durchgänge auf mehreren Stufen ergänzen</translation>
    </message>
    <message>
        <source>there are no trials without a difference, or none with one: complete the session</source>
        <translation>es gibt keine Durchgänge ohne Unterschied oder keine mit Unterschied: Führen Sie die Sitzung zu Ende</translation>
    </message>
    <message>
        <source>every response is the same: check that the question was understood</source>
        <translation>alle Antworten sind gleich: Prüfen Sie, ob die Frage verstanden wurde</translation>
    </message>
    <message>
        <source>a step function fits perfectly: present levels between those on either side of the step</source>
        <translation>eine Stufenfunktion passt genau: Bieten Sie Stufen zwischen denen beiderseits des Sprungs dar</translation>
    </message>
    <message>
        <source>hits are not more frequent than false alarms, as if the responses were guesses: check the responses in the practice before you present other levels</source>
        <translation>Treffer sind nicht häufiger als falsche Alarme, als wären die Antworten geraten: Prüfen Sie die Antworten in der Übung, bevor Sie andere Stufen darbieten</translation>
    </message>
    <message>
        <source>one level differs from the standard, and a function requires two: see d′ in the table of sensitivities</source>
        <translation>nur eine Stufe unterscheidet sich vom Standard, und eine Funktion erfordert zwei: siehe d′ in der Tabelle der Sensitivitäten</translation>
    </message>
</context>
<context>
    <name>MouseTrial</name>
    <message>
        <source>the protocol takes its levels from an external program; run a pilot session with the mouse to try it</source>
        <translation>das Protokoll erhält seine Stufen von einem externen Programm; zum Ausprobieren eine Pilotsitzung mit der Maus starten</translation>
    </message>
</context>
<context>
    <name>NewStudy</name>
    <message>
        <source>This is version %1. Before 1.0.0, finish a study with the version that began it; the package of each version stays available.</source>
        <translation>Dies ist Version %1. Schließen Sie vor 1.0.0 eine Studie mit der Version ab, mit der sie begonnen wurde; das Paket jeder Version bleibt verfügbar.</translation>
    </message>
</context>
<context>
    <name>OfferedReasons</name>
    <message>
        <source>The participant was distracted</source>
        <translation>Die Versuchsperson war abgelenkt</translation>
    </message>
    <message>
        <source>Wrong key pressed</source>
        <translation>Falsche Taste gedrückt</translation>
    </message>
    <message>
        <source>Requested by the participant</source>
        <translation>Auf Bitte der Versuchsperson</translation>
    </message>
    <message>
        <source>The participant cannot answer</source>
        <translation>Die Versuchsperson kann nicht antworten</translation>
    </message>
    <message>
        <source>The participant does not want to continue</source>
        <translation>Die Versuchsperson möchte nicht weitermachen</translation>
    </message>
    <message>
        <source>The participant wishes to stop</source>
        <translation>Die Versuchsperson möchte aufhören</translation>
    </message>
    <message>
        <source>The participant is unwell</source>
        <translation>Der Versuchsperson ist nicht wohl</translation>
    </message>
    <message>
        <source>Technical problem</source>
        <translation>Technisches Problem</translation>
    </message>
    <message>
        <source>Safety of the participant</source>
        <translation>Sicherheit der Versuchsperson</translation>
    </message>
    <message>
        <source>Suspected fault of a stimulus</source>
        <translation>Verdacht auf einen fehlerhaften Reiz</translation>
    </message>
    <message>
        <source>Not the experimenter of this study</source>
        <translation>Nicht die Versuchsleitung dieser Studie</translation>
    </message>
    <message>
        <source>The participant seemed distracted</source>
        <translation>Die Versuchsperson wirkte abgelenkt</translation>
    </message>
    <message>
        <source>The hand slipped</source>
        <translation>Die Hand ist abgerutscht</translation>
    </message>
    <message>
        <source>A person entered the room</source>
        <translation>Eine Person betrat den Raum</translation>
    </message>
    <message>
        <source>The force felt wrong</source>
        <translation>Die Kraft fühlte sich falsch an</translation>
    </message>
    <message>
        <source>The participant retracted the response</source>
        <translation>Die Versuchsperson nahm die Antwort zurück</translation>
    </message>
    <message>
        <source>The participant withdrew consent</source>
        <translation>Die Versuchsperson widerrief die Einwilligung</translation>
    </message>
    <message>
        <source>The participant did not follow the instruction</source>
        <translation>Die Versuchsperson folgte der Anweisung nicht</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Answered by mistake</source>
        <translation>Aus Versehen beantwortet</translation>
    </message>
    <message>
        <source>The device malfunctioned</source>
        <translation>Fehlfunktion des Geräts</translation>
    </message>
    <message>
        <source>The surface was recognised by cues other than touch</source>
        <translation>Die Oberfläche wurde nicht durch Berührung, sondern an anderen Hinweisen erkannt</translation>
    </message>
    <message>
        <source>It was a test run</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>Excluded by mistake</source>
        <translation>Aus Versehen ausgeschlossen</translation>
    </message>
    <message>
        <source>The reason proved unfounded</source>
        <translation>Der Grund hat sich nicht bestätigt</translation>
    </message>
    <message>
        <source>Pressed hard</source>
        <translation>Fest gedrückt</translation>
    </message>
    <message>
        <source>Lifted early</source>
        <translation>Früh abgehoben</translation>
    </message>
    <message>
        <source>Grip changed</source>
        <translation>Umgegriffen</translation>
    </message>
    <message>
        <source>Hand slipped</source>
        <translation>Abgerutscht</translation>
    </message>
    <message>
        <source>Hand is tired</source>
        <translation>Hand müde</translation>
    </message>
    <message>
        <source>Felt a jolt</source>
        <translation>Ruck gespürt</translation>
    </message>
    <message>
        <source>Distracted</source>
        <translation>Abgelenkt</translation>
    </message>
    <message>
        <source>Had a question</source>
        <translation>Hatte Frage</translation>
    </message>
    <message>
        <source>Noise outside</source>
        <translation>Lärm von außen</translation>
    </message>
    <message>
        <source>The participant was not eligible</source>
        <translation>Die Versuchsperson war nicht teilnahmeberechtigt</translation>
    </message>
    <message>
        <source>The participant was withdrawn</source>
        <translation>Die Versuchsperson wurde aus der Studie genommen</translation>
    </message>
</context>
<context>
    <name>OpeningWords</name>
    <message>
        <source>%1 is a folder; open one of the pictures in it.</source>
        <translation>%1 ist ein Ordner; eines der Bilder darin öffnen.</translation>
    </message>
    <message>
        <source>%1 was not found; it may have been moved, or its disk removed. Open the picture from its new location.</source>
        <translation>%1 wurde nicht gefunden; möglicherweise wurde es verschoben oder der Datenträger entfernt. Das Bild vom neuen Ort öffnen.</translation>
    </message>
    <message>
        <source>%1 is %2 GiB in size; pictures of up to 2 GiB can be read. Scale it down or crop it.</source>
        <translation>%1 ist %2 GiB groß; das Programm liest Bilder bis 2 GiB. Das Bild verkleinern oder zuschneiden.</translation>
    </message>
    <message>
        <source>The picture has an alpha channel, which is ignored: each pixel is read with its full colour, regardless of its transparency.</source>
        <translation>Das Bild hat einen Alphakanal; er bleibt unberücksichtigt: Jeder Bildpunkt wird mit seiner vollen Farbe gelesen, unabhängig von seiner Transparenz.</translation>
    </message>
    <message>
        <source>The camera stored a rotation with the picture; here the picture is shown without this rotation. If the orientation matters, rotate and save the picture with another program.</source>
        <translation>Die Kamera hat mit dem Bild eine Drehung gespeichert; hier wird es ohne diese Drehung gezeigt. Falls es auf die Ausrichtung ankommt, das Bild mit einem anderen Programm drehen und speichern.</translation>
    </message>
    <message>
        <source>%1 does not fit into the memory of this computer. Scale it down or crop it.</source>
        <translation>%1 passt nicht in den Speicher dieses Rechners. Das Bild verkleinern oder zuschneiden.</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened. Open it again.</source>
        <translation>%1 hat sich geändert, seit es geöffnet wurde. Das Bild erneut öffnen.</translation>
    </message>
    <message>
        <source>%1 is not a picture file; open a PNG, JPEG, TIFF, BMP or WebP file.</source>
        <translation>%1 ist keine Bilddatei; eine PNG-, JPEG-, TIFF-, BMP- oder WebP-Datei öffnen.</translation>
    </message>
    <message>
        <source>%1 contains heights, but neither their unit nor the width of the surface. Convert it with “asperity texture”, and open the result.</source>
        <translation>%1 enthält Höhen, aber weder ihre Einheit noch die Breite der Oberfläche. Wandeln Sie die Datei mit „asperity texture“ um und öffnen Sie das Ergebnis.</translation>
    </message>
</context>
<context>
    <name>OutcomeWords</name>
    <message>
        <source>answered</source>
        <translation>beantwortet</translation>
    </message>
    <message>
        <source>no response in time</source>
        <translation>keine rechtzeitige Antwort</translation>
    </message>
    <message>
        <source>not explored as instructed</source>
        <translation>nicht wie angewiesen exploriert</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>übersprungen</translation>
    </message>
</context>
<context>
    <name>ParticipantAnswers</name>
    <message>
        <source>&quot;%1&quot; has not been answered; enter an answer.</source>
        <translation>„%1“ wurde nicht beantwortet; eine Antwort eingeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of the answers to &quot;%2&quot;; choose one of them.</source>
        <translation>„%1“ ist keine der Antworten auf „%2“; eine davon wählen.</translation>
    </message>
    <message>
        <source>The answer to &quot;%1&quot; must be a number.</source>
        <translation>Die Antwort auf „%1“ muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>The answer to &quot;%1&quot; must be %2 or more.</source>
        <translation>Die Antwort auf „%1“ muss mindestens %2 betragen.</translation>
    </message>
    <message>
        <source>The answer to &quot;%1&quot; must be %2 or less.</source>
        <translation>Die Antwort auf „%1“ darf höchstens %2 betragen.</translation>
    </message>
</context>
<context>
    <name>ParticipantLayout</name>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1 or less</source>
        <translation>%1 oder weniger</translation>
    </message>
    <message>
        <source>Block %1 of %2</source>
        <translation>Block %1 von %2</translation>
    </message>
    <message>
        <source>Feel again</source>
        <translation>Noch einmal fühlen</translation>
    </message>
    <message>
        <source>Feel %1 again</source>
        <translation>%1 noch einmal fühlen</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabetaste</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Any number above 0</source>
        <translation>Eine beliebige Zahl über 0</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>Geschwindigkeit, mm/s</translation>
    </message>
    <message>
        <source>This is not a number above 0. Please correct it.</source>
        <translation>Das ist keine Zahl über 0. Bitte berichtigen Sie Ihre Eingabe.</translation>
    </message>
    <message>
        <source>This is not a number. Please correct it.</source>
        <translation>Das ist keine Zahl. Bitte berichtigen Sie Ihre Eingabe.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Finish with this surface</source>
        <translation>Diese Oberfläche abschließen</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>You can continue in %1</source>
        <translation>Sie können in %1 fortfahren</translation>
    </message>
    <message>
        <source>You can continue when you are ready.</source>
        <translation>Sie können fortfahren, sobald Sie bereit sind.</translation>
    </message>
    <message>
        <source>One moment, please. You may release the handle.</source>
        <translation>Einen Moment bitte. Sie können den Griff loslassen.</translation>
    </message>
    <message>
        <source>Thank you. You may release the handle.</source>
        <translation>Vielen Dank. Sie können den Griff loslassen.</translation>
    </message>
    <message>
        <source>Feel %1</source>
        <translation>%1 fühlen</translation>
    </message>
    <message>
        <source>Finish with these surfaces</source>
        <translation>Diese Oberflächen abschließen</translation>
    </message>
    <message>
        <source>Choose all that apply.</source>
        <translation>Wählen Sie alles aus, was zutrifft.</translation>
    </message>
    <message>
        <source>Press where the line is to end, or use the keys ← and →.</source>
        <translation>Drücken Sie dort, wo die Linie enden soll, oder benutzen Sie die Tasten ← und →.</translation>
    </message>
    <message>
        <source>Keep the left mouse button pressed on the surface, and stroke it.</source>
        <translation>Halten Sie auf der Oberfläche die linke Maustaste gedrückt und streichen Sie über sie.</translation>
    </message>
</context>
<context>
    <name>ParticipantWords</name>
    <message>
        <source>Feel surface %1 now.</source>
        <translation>Fühlen Sie jetzt Oberfläche %1.</translation>
    </message>
    <message>
        <source>Please put on the eye mask.</source>
        <translation>Bitte setzen Sie die Augenbinde auf.</translation>
    </message>
    <message>
        <source>Please take off the eye mask.</source>
        <translation>Bitte nehmen Sie die Augenbinde ab.</translation>
    </message>
    <message>
        <source>I cannot tell</source>
        <translation>Ich kann es nicht sagen</translation>
    </message>
    <message>
        <source>Please feel surface %1 first.</source>
        <translation>Bitte fühlen Sie zuerst Oberfläche %1.</translation>
    </message>
    <message>
        <source>Please feel surface %1 a little longer.</source>
        <translation>Bitte fühlen Sie Oberfläche %1 noch etwas länger.</translation>
    </message>
    <message>
        <source>Please choose first.</source>
        <translation>Bitte wählen Sie zuerst.</translation>
    </message>
    <message>
        <source>The surfaces cannot be felt again. Please answer without feeling them.</source>
        <translation>Die Oberflächen können nicht noch einmal gefühlt werden. Bitte antworten Sie, ohne sie zu fühlen.</translation>
    </message>
    <message>
        <source>Please enter a number from %1 to %2.</source>
        <translation>Bitte geben Sie eine Zahl von %1 bis %2 an.</translation>
    </message>
    <message>
        <source>Please enter a number of at least %1.</source>
        <translation>Bitte geben Sie eine Zahl von mindestens %1 an.</translation>
    </message>
    <message>
        <source>Please enter a number of at most %1.</source>
        <translation>Bitte geben Sie eine Zahl von höchstens %1 an.</translation>
    </message>
    <message>
        <source>Please enter a number.</source>
        <translation>Bitte geben Sie eine Zahl an.</translation>
    </message>
    <message>
        <source>Please choose one of the answers.</source>
        <translation>Bitte wählen Sie eine der Antworten.</translation>
    </message>
    <message>
        <source>Please wait for the question.</source>
        <translation>Bitte warten Sie auf die Frage.</translation>
    </message>
    <message>
        <source>Confirm to feel surface %1 again.</source>
        <translation>Bestätigen Sie, um Oberfläche %1 noch einmal zu fühlen.</translation>
    </message>
    <message>
        <source>Please wait 1 more second.</source>
        <translation>Bitte warten Sie noch 1 Sekunde.</translation>
    </message>
    <message>
        <source>Please wait %1 more seconds.</source>
        <translation>Bitte warten Sie noch %1 Sekunden.</translation>
    </message>
    <message>
        <source>Please enter a number above 0, such as 7 or 0.5.</source>
        <translation>Bitte geben Sie eine Zahl über 0 an, etwa 7 oder 0,5.</translation>
    </message>
    <message>
        <source>The session continues where it was interrupted. Confirm when you are ready.</source>
        <translation>Die Sitzung wird dort fortgesetzt, wo sie unterbrochen wurde. Bestätigen Sie, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>You have finished with surface %1. Please lift the handle.</source>
        <translation>Sie sind mit Oberfläche %1 fertig. Bitte heben Sie den Griff an.</translation>
    </message>
    <message>
        <source>Please assign a picture to surface %1 first.</source>
        <translation>Bitte ordnen Sie zuerst Oberfläche %1 ein Bild zu.</translation>
    </message>
    <message>
        <source>Correct.</source>
        <translation>Richtig.</translation>
    </message>
    <message>
        <source>Incorrect.</source>
        <translation>Nicht richtig.</translation>
    </message>
    <message>
        <source>Incorrect. The correct response is %1.</source>
        <translation>Nicht richtig. Die richtige Antwort ist %1.</translation>
    </message>
    <message>
        <source>Please answer this question.</source>
        <translation>Bitte beantworten Sie diese Frage.</translation>
    </message>
    <message>
        <source>%1 is ambiguous. Please write thousands without a point or a comma, and decimals with one or two decimal places.</source>
        <translation>%1 ist mehrdeutig. Bitte schreiben Sie Tausender ohne Punkt oder Komma und Dezimalzahlen mit einer oder zwei Nachkommastellen.</translation>
    </message>
    <message>
        <source>Please check the number %1: enter it again, or enter the number that you meant.</source>
        <translation>Bitte prüfen Sie die Zahl %1: Geben Sie dieselbe Zahl noch einmal ein oder die Zahl, die Sie gemeint haben.</translation>
    </message>
    <message>
        <source>Please wait for the experimenter.</source>
        <translation>Bitte warten Sie auf die Versuchsleitung.</translation>
    </message>
    <message>
        <source>Please mark a point on the scale first.</source>
        <translation>Bitte markieren Sie zuerst einen Punkt auf der Skala.</translation>
    </message>
    <message>
        <source>Please mark a point on every scale first.</source>
        <translation>Bitte markieren Sie zuerst auf jeder Skala einen Punkt.</translation>
    </message>
    <message>
        <source>You have finished with these surfaces. Please lift the handle.</source>
        <translation>Sie sind mit diesen Oberflächen fertig. Bitte heben Sie den Griff an.</translation>
    </message>
    <message>
        <source>Surface %1 cannot be felt again. Please continue without it.</source>
        <translation>Oberfläche %1 kann nicht noch einmal gefühlt werden. Bitte fahren Sie ohne sie fort.</translation>
    </message>
    <message>
        <source>Feel surfaces %1 and %2 now. They lie side by side.</source>
        <translation>Fühlen Sie jetzt die Oberflächen %1 und %2. Sie liegen nebeneinander.</translation>
    </message>
    <message>
        <source>Feel surfaces %1 to %2 now. They lie side by side.</source>
        <translation>Fühlen Sie jetzt die Oberflächen %1 bis %2. Sie liegen nebeneinander.</translation>
    </message>
    <message>
        <source>Please feel each of the surfaces again, and a little longer.</source>
        <translation>Bitte fühlen Sie jede der Oberflächen noch einmal und etwas länger.</translation>
    </message>
    <message>
        <source>Please finish with these surfaces first.</source>
        <translation>Bitte schließen Sie zuerst diese Oberflächen ab.</translation>
    </message>
    <message>
        <source>Confirm to feel surface %1.</source>
        <translation>Bestätigen Sie, um Oberfläche %1 zu fühlen.</translation>
    </message>
    <message>
        <source>First, please do some practice trials again. They do not count. Confirm when you are ready.</source>
        <translation>Bitte wiederholen Sie zuerst einige Übungsdurchgänge. Sie zählen nicht. Bestätigen Sie, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>Please choose one or more of the answers.</source>
        <translation>Bitte wählen Sie eine oder mehrere der Antworten.</translation>
    </message>
    <message>
        <source>Please draw a line first.</source>
        <translation>Bitte zeichnen Sie zuerst eine Linie.</translation>
    </message>
    <message>
        <source>Surface %1 was not touched.</source>
        <translation>Oberfläche %1 wurde nicht berührt.</translation>
    </message>
    <message>
        <source>Please confirm with the keyboard or on the screen.</source>
        <translation>Bitte mit der Tastatur oder am Bildschirm bestätigen.</translation>
    </message>
</context>
<context>
    <name>PluginBuilds</name>
    <message>
        <source>the study has attempts of this protocol with another build of the plug-in of the force model %1, version %2 (attempts: %3, SHA-256: %4; the loaded plug-in has the SHA-256 %5); they would be analysed together with new ones</source>
        <translation>die Studie hat Versuche dieses Protokolls mit einem anderen Build des Plug-ins des Kraftmodells %1, Version %2 (Versuche: %3, SHA-256: %4; das geladene Plug-in hat die SHA-256 %5); sie würden zusammen mit neuen ausgewertet</translation>
    </message>
    <message>
        <source>raise the version of the plug-in if its forces have changed, or load the build that rendered the attempts</source>
        <translation>die Version des Plug-ins erhöhen, wenn sich seine Kräfte geändert haben, oder den Build laden, mit dem die Versuche dargeboten wurden</translation>
    </message>
</context>
<context>
    <name>ProfileWords</name>
    <message>
        <source>Servo rate</source>
        <translation>Taktrate der Servoschleife</translation>
    </message>
    <message>
        <source>Lateness, median</source>
        <translation>Verspätung, Median</translation>
    </message>
    <message>
        <source>Lateness, 99th percentile</source>
        <translation>Verspätung, 99. Perzentil</translation>
    </message>
    <message>
        <source>Lateness, maximum</source>
        <translation>Verspätung, Maximum</translation>
    </message>
    <message>
        <source>Missed deadlines</source>
        <translation>Verpasste Fristen</translation>
    </message>
    <message>
        <source>Force without a surface</source>
        <translation>Kraft ohne Oberfläche</translation>
    </message>
    <message>
        <source>Position noise at rest</source>
        <translation>Positionsrauschen in Ruhe</translation>
    </message>
    <message>
        <source>Compliance with the force limit</source>
        <translation>Einhaltung der Kraftgrenze</translation>
    </message>
    <message>
        <source>Zero force after a stop</source>
        <translation>Kraft null nach einem Halt</translation>
    </message>
    <message>
        <source>Zero force when the program stops responding</source>
        <translation>Kraft null, wenn das Programm nicht mehr reagiert</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Position step</source>
        <translation>Positionsschritt</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Moving mass</source>
        <translation>Bewegte Masse</translation>
    </message>
    <message>
        <source>Lowest resonance</source>
        <translation>Niedrigste Resonanz</translation>
    </message>
    <message>
        <source>Stiffest stable spring</source>
        <translation>Steifste stabile Feder</translation>
    </message>
    <message>
        <source>Smallest force that moves the handle</source>
        <translation>Kleinste Kraft, die den Griff bewegt</translation>
    </message>
    <message>
        <source>Fraction of the workspace reached</source>
        <translation>Erreichter Anteil des Arbeitsraums</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>kein Grenzwert</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Zeitverhalten</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mechanik</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 nicht bestanden</translation>
    </message>
    <message>
        <source>%1 passed</source>
        <translation>%1 bestanden</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1 nicht gemessen</translation>
    </message>
    <message>
        <source>less than a day</source>
        <translation>weniger als ein Tag</translation>
    </message>
    <message>
        <source>a day</source>
        <translation>ein Tag</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 Tage</translation>
    </message>
    <message>
        <source>Zero force instead of a force that is not finite</source>
        <translation>Kraft null statt einer Kraft, die keine endliche Zahl ist</translation>
    </message>
</context>
<context>
    <name>ProtocolFiles</name>
    <message>
        <source>the protocol&apos;s force_limit_N of %1 N exceeds the peak force of the device &quot;%2&quot;, %3 N</source>
        <translation>force_limit_N des Protokolls, %1 N, übersteigt die Spitzenkraft des Geräts „%2“, %3 N</translation>
    </message>
    <message>
        <source>the protocol&apos;s rate_Hz of %1 Hz exceeds the highest rate of the device &quot;%2&quot;, %3 Hz</source>
        <translation>rate_Hz des Protokolls, %1 Hz, übersteigt die höchste Taktrate des Geräts „%2“, %3 Hz</translation>
    </message>
    <message>
        <source>the participant label &quot;%1&quot; is not acceptable for a human participant: labels that begin with &quot;virtual&quot; are reserved for virtual participants; use another label</source>
        <translation>das Kürzel „%1“ ist für eine menschliche Versuchsperson nicht zulässig: Kürzel, die mit „virtual“ beginnen, sind virtuellen Versuchspersonen vorbehalten; ein anderes Kürzel verwenden</translation>
    </message>
    <message>
        <source>the participant label &quot;%1&quot; is not acceptable: it must consist of 1 to 32 letters and digits (0-9, A-Z, a-z)</source>
        <translation>das Kürzel „%1“ ist nicht zulässig: Erlaubt sind 1 bis 32 Buchstaben und Ziffern (0-9, A-Z, a-z)</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>on request</source>
        <translation>auf Wunsch</translation>
    </message>
    <message>
        <source>on request, after the trial</source>
        <translation>auf Wunsch, nach dem Durchgang</translation>
    </message>
    <message>
        <source>on request, after the block</source>
        <translation>auf Wunsch, nach dem Block</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>auf Wunsch gestoppt</translation>
    </message>
    <message>
        <source>the terminal was closed</source>
        <translation>das Terminal wurde geschlossen</translation>
    </message>
    <message>
        <source>the window was closed</source>
        <translation>das Fenster wurde geschlossen</translation>
    </message>
    <message>
        <source>the session window was closed</source>
        <translation>das Sitzungsfenster wurde geschlossen</translation>
    </message>
    <message>
        <source>the emergency stop was pressed in trial %1</source>
        <translation>der NOT-HALT wurde in Durchgang %1 gedrückt</translation>
    </message>
    <message>
        <source>the emergency stop was pressed between trials</source>
        <translation>der NOT-HALT wurde zwischen zwei Durchgängen gedrückt</translation>
    </message>
    <message>
        <source>a fault occurred in trial %1: %2</source>
        <translation>in Durchgang %1 ist eine Störung aufgetreten: %2</translation>
    </message>
    <message>
        <source>a fault occurred between trials: %1</source>
        <translation>zwischen zwei Durchgängen ist eine Störung aufgetreten: %1</translation>
    </message>
    <message>
        <source>every completed trial is stored; resume with --resume</source>
        <translation>jeder abgeschlossene Durchgang ist gespeichert, die Sitzung kann fortgesetzt werden</translation>
    </message>
    <message>
        <source>trial %1 failed %2 times in a row (%3)</source>
        <translation>Durchgang %1 ist %2-mal hintereinander fehlgeschlagen (%3)</translation>
    </message>
    <message>
        <source>the criterion of the block &quot;%1&quot; was not met</source>
        <translation>das Kriterium des Blocks „%1“ wurde nicht erreicht</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>the masking noise stopped</source>
        <translation>das Maskierrauschen ist verstummt</translation>
    </message>
    <message>
        <source>%1 of %3 ticks are missing from the recording, at most %2 allowed: the computer or its disk was busy for seconds, and force, speed and strokes of this attempt are not completely known; close other programs, and keep the study on a local disk</source>
        <translation>%1 von %3 Takten fehlen in der Aufzeichnung, höchstens %2 erlaubt: Der Rechner oder sein Datenträger war sekundenlang ausgelastet, und Kraft, Geschwindigkeit und Striche dieses Versuchs sind nicht vollständig bekannt; andere Programme schließen und die Studie auf einem lokalen Datenträger speichern</translation>
    </message>
    <message>
        <source>ticks with limited force: %1</source>
        <translation>Kraft begrenzt, Takte: %1</translation>
    </message>
    <message>
        <source>not explored as instructed: %1</source>
        <translation>nicht wie angewiesen exploriert: %1</translation>
    </message>
    <message>
        <source>surface %1 was not touched</source>
        <translation>Oberfläche %1 wurde nicht berührt</translation>
    </message>
    <message>
        <source>repeated by the experimenter: %1</source>
        <translation>von der Versuchsleitung wiederholt: %1</translation>
    </message>
    <message>
        <source>the device is not ready: %1</source>
        <translation>das Gerät ist nicht bereit: %1</translation>
    </message>
    <message>
        <source>its servo loop is not running</source>
        <translation>seine Servoschleife läuft nicht</translation>
    </message>
    <message>
        <source>it does not respond</source>
        <translation>es antwortet nicht</translation>
    </message>
    <message>
        <source>the position of the device jumped; home the device again</source>
        <translation>die Position des Geräts ist gesprungen; das Gerät muss neu referenziert werden</translation>
    </message>
    <message>
        <source>a force is sent although there is no surface</source>
        <translation>eine Kraft wird gesendet, obwohl keine Oberfläche dargeboten wird</translation>
    </message>
    <message>
        <source>%1 of surface %2</source>
        <translation>%1 bei Oberfläche %2</translation>
    </message>
    <message>
        <source>normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>time in contact</source>
        <translation>Kontaktdauer</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Anzahl der Striche</translation>
    </message>
    <message>
        <source>stroke length</source>
        <translation>Strichlänge</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>NOT-HALT</translation>
    </message>
    <message>
        <source>the device does not respond</source>
        <translation>das Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>a force or position that is not a finite number</source>
        <translation>eine Kraft oder Position, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>the probe left the workspace</source>
        <translation>der Taster hat den Arbeitsraum verlassen</translation>
    </message>
    <message>
        <source>too many missed deadlines within a second: the computer was busy, or the servo rate is too high for it</source>
        <translation>zu viele verpasste Fristen innerhalb einer Sekunde: Der Rechner war ausgelastet, oder die Servorate ist zu hoch für ihn</translation>
    </message>
    <message>
        <source>the emergency stop was pressed</source>
        <translation>der NOT-HALT wurde gedrückt</translation>
    </message>
    <message>
        <source>the masking noise could not start</source>
        <translation>das Maskierrauschen konnte nicht starten</translation>
    </message>
    <message>
        <source>the servo loop stalled for more than 50 ms, %1 times: the computer was suspended, the program was stopped, or other programs kept it from running</source>
        <translation>die Servoschleife stand %1-mal länger als 50 ms still: Der Rechner war im Ruhezustand, das Programm war angehalten, oder andere Programme verhinderten seine Ausführung</translation>
    </message>
    <message>
        <source>the servo loop stalled for more than 50 ms</source>
        <translation>die Servoschleife stand länger als 50 ms still</translation>
    </message>
    <message>
        <source>gaps between ticks in contact: %1, at most %2 allowed</source>
        <translation>Lücken zwischen Takten im Kontakt: %1, höchstens %2 erlaubt</translation>
    </message>
    <message>
        <source>deadlines missed in contact: %1, at most %2 allowed</source>
        <translation>verpasste Fristen im Kontakt: %1, höchstens %2 erlaubt</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>kein Grund angegeben</translation>
    </message>
    <message>
        <source>no trial has been answered or skipped yet</source>
        <translation>es wurde noch kein Durchgang beantwortet oder übersprungen</translation>
    </message>
    <message>
        <source>consent witnessed by %1</source>
        <translation>Einwilligung bezeugt von %1</translation>
    </message>
    <message>
        <source>visits to surface %1: %2 of at least %3</source>
        <translation>Besuche der Oberfläche %1: %2 von mindestens %3</translation>
    </message>
    <message>
        <source>a visit to surface %1 ended before the required number of strokes or contact time</source>
        <translation>ein Besuch der Oberfläche %1 endete vor der vorgegebenen Zahl der Striche oder Kontaktzeit</translation>
    </message>
    <message>
        <source>practice trials are being repeated, and they do not count</source>
        <translation>es werden Übungsdurchgänge wiederholt, die nicht zählen</translation>
    </message>
    <message>
        <source>surface %1 vibrated: buzz %2, at most %3 allowed</source>
        <translation>Oberfläche %1 vibrierte: buzz %2, höchstens %3 erlaubt</translation>
    </message>
    <message>
        <source>the levels could not be determined: %1</source>
        <translation>die Stufen konnten nicht bestimmt werden: %1</translation>
    </message>
    <message>
        <source>the plug-in of the force model %1 failed: %2</source>
        <translation>das Plug-in des Kraftmodells %1 ist ausgefallen: %2</translation>
    </message>
    <message>
        <source>end this program and start it again, then resume the session</source>
        <translation>dieses Programm beenden und neu starten, dann die Sitzung fortsetzen</translation>
    </message>
    <message>
        <source>a tick of the force model %1 did not return</source>
        <translation>ein Takt des Kraftmodells %1 kehrte nicht zurück</translation>
    </message>
    <message>
        <source>a tick did not return from the driver of the device</source>
        <translation>ein Takt kehrte nicht aus dem Treiber des Geräts zurück</translation>
    </message>
</context>
<context>
    <name>Rehearsal</name>
    <message>
        <source>&quot;%1&quot; cannot be compared with the device: %2</source>
        <translation>„%1“ lässt sich nicht mit dem Gerät vergleichen: %2</translation>
    </message>
    <message>
        <source>The texture of &quot;%1&quot; corresponds to a force of %2 N RMS, and the device&apos;s own friction is %3 N, which masks the texture. Raise the amplitude of the texture, or choose a device with less friction.</source>
        <translation>Die Textur von „%1“ entspricht einem Effektivwert der Kraft von %2 N; die Reibung des Geräts beträgt %3 N und maskiert die Textur. Die Amplitude der Textur erhöhen oder ein Gerät mit geringerer Reibung wählen.</translation>
    </message>
    <message>
        <source>The texture of &quot;%1&quot; corresponds to a force of %2 N RMS, and the smallest force that moves the device is %3 N. Raise the amplitude of the texture, or choose a device with a finer force resolution.</source>
        <translation>Die Textur von „%1“ entspricht einem Effektivwert der Kraft von %2 N; die kleinste Kraft, die das Gerät bewegt, beträgt %3 N. Die Amplitude der Textur erhöhen oder ein Gerät mit feinerer Kraftauflösung wählen.</translation>
    </message>
    <message>
        <source>The wavelength of &quot;%1&quot; is %2 µm, and the device measures positions in steps of %3 µm: at least two steps per wavelength are needed. Choose a longer wavelength, or a device with a finer position resolution.</source>
        <translation>Die Wellenlänge von „%1“ beträgt %2 µm, und das Gerät misst Positionen in Schritten von %3 µm: Je Wellenlänge sind mindestens zwei Schritte nötig. Eine größere Wellenlänge oder ein Gerät mit feinerer Positionsauflösung wählen.</translation>
    </message>
    <message>
        <source>When &quot;%1&quot; is stroked at %2 mm/s, its temporal frequency is %3 Hz, and the bandwidth of the device is %4 Hz. Lower the speed, or choose a longer wavelength or a device with a higher bandwidth.</source>
        <translation>Wird mit %2 mm/s über „%1“ gestrichen, beträgt die zeitliche Frequenz %3 Hz; die Bandbreite des Geräts beträgt %4 Hz. Die Geschwindigkeit verringern oder eine größere Wellenlänge oder ein Gerät mit größerer Bandbreite wählen.</translation>
    </message>
    <message>
        <source>The surface lies from %1 to %2 mm along %3, and the handle reaches from %4 to %5 mm. Move the surface or make it smaller, or choose a device with a larger workspace.</source>
        <translation>Die Oberfläche liegt entlang %3 von %1 bis %2 mm, und der Griff erreicht %4 bis %5 mm. Die Oberfläche verschieben oder verkleinern oder ein Gerät mit größerem Arbeitsraum wählen.</translation>
    </message>
    <message>
        <source>The protocol requires a device whose %1 is at most %2; the measured value is %3. Choose another device, or relax the requirement in the protocol.</source>
        <translation>Das Protokoll verlangt ein Gerät, dessen Kennwert %1 höchstens %2 beträgt; der gemessene Wert ist %3. Ein anderes Gerät wählen oder die Anforderung im Protokoll senken.</translation>
    </message>
    <message>
        <source>The protocol requires a device whose %1 is at least %2; the measured value is %3. Choose another device, or relax the requirement in the protocol.</source>
        <translation>Das Protokoll verlangt ein Gerät, dessen Kennwert %1 mindestens %2 beträgt; der gemessene Wert ist %3. Ein anderes Gerät wählen oder die Anforderung im Protokoll senken.</translation>
    </message>
    <message>
        <source>The protocol requires a device whose %1 is at most %2, but this quantity was not measured. Measure the device again, or remove the limit from the protocol.</source>
        <translation>Das Protokoll verlangt ein Gerät, dessen Kennwert %1 höchstens %2 beträgt; dieser wurde nicht gemessen. Das Gerät erneut messen oder den Grenzwert aus dem Protokoll entfernen.</translation>
    </message>
    <message>
        <source>The protocol requires a device whose %1 is at least %2, but this quantity was not measured. Measure the device again, or remove the limit from the protocol.</source>
        <translation>Das Protokoll verlangt ein Gerät, dessen Kennwert %1 mindestens %2 beträgt; dieser wurde nicht gemessen. Das Gerät erneut messen oder den Grenzwert aus dem Protokoll entfernen.</translation>
    </message>
    <message>
        <source>requirements of the protocol that the device does not meet: %1. %2</source>
        <translation>Anforderungen des Protokolls, die das Gerät nicht erfüllt: %1. %2</translation>
    </message>
    <message>
        <source>The texture of &quot;%1&quot; has an amplitude of %2 µm (√2 times its RMS), and the device measures positions in steps of %3 µm. Raise the amplitude of the texture, or choose a device with a finer position resolution.</source>
        <translation>Die Textur von „%1“ hat eine Amplitude von %2 µm (√2-mal ihr Effektivwert), und das Gerät misst Positionen in Schritten von %3 µm. Die Amplitude der Textur erhöhen oder ein Gerät mit feinerer Positionsauflösung wählen.</translation>
    </message>
    <message>
        <source>At the force limit of %2 N, the greatest stiffness of &quot;%1&quot; is %3 N/m; the device renders up to %4 N/m without oscillation. Lower the stiffness, or choose another device.</source>
        <translation>An der Kraftgrenze von %2 N beträgt die größte Steifigkeit von „%1“ %3 N/m; das Gerät gibt bis zu %4 N/m ohne Schwingen wieder. Die Steifigkeit verringern oder ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>At the greatest force that &quot;%1&quot; exerts at its stiffest place, %2 N, its stiffness is %3 N/m; the device renders up to %4 N/m without oscillation. Lower the stiffness, or choose another device.</source>
        <translation>Bei der größten Kraft, die „%1“ an der steifsten Stelle ausübt, %2 N, beträgt die Steifigkeit %3 N/m; das Gerät gibt bis zu %4 N/m ohne Schwingen wieder. Die Steifigkeit verringern oder ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>the protocol requires a device that meets its limits, but the study has no profile of &quot;%1&quot;; measure the device with %2</source>
        <translation>das Protokoll verlangt ein Gerät, das die Grenzwerte des Protokolls einhält, aber die Studie hat kein Profil von „%1“; das Gerät mit %2 messen</translation>
    </message>
    <message>
        <source>the protocol requires a device measured within %1 days, but the study has no profile of &quot;%2&quot;; measure the device with %3</source>
        <translation>das Protokoll verlangt ein Gerät, dessen Messung höchstens %1 Tage zurückliegt, aber die Studie hat kein Profil von „%2“; das Gerät mit %3 messen</translation>
    </message>
    <message>
        <source>the profile of &quot;%1&quot; is %2 days old, but the protocol allows at most %3; measure the device again with %4</source>
        <translation>das Profil von „%1“ ist %2 Tage alt, aber das Protokoll erlaubt höchstens %3; das Gerät erneut mit %4 messen</translation>
    </message>
    <message>
        <source>the profile of &quot;%1&quot; is dated %2, which is in the future: correct the clock of the computer, and measure the device again with %3</source>
        <translation>das Profil von „%1“ trägt das Datum %2, das in der Zukunft liegt: die Uhr des Rechners stellen und das Gerät erneut mit %3 messen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; failed %2 when it was measured on %3, but the protocol requires a device that passed; repair the device, and measure it again with %4</source>
        <translation>„%1“ hat %2 nicht bestanden, als es am %3 gemessen wurde, aber das Protokoll verlangt ein Gerät, das bestanden hat; den Mangel beheben und das Gerät erneut mit %4 messen</translation>
    </message>
    <message>
        <source>The stiffness of &quot;%1&quot; could not be determined or compared with the %2 N/m that the device renders without oscillation: at every place examined its force jumps or does not increase. Check on the device that the stimulus does not cause oscillation.</source>
        <translation>Die Steifigkeit von „%1“ ließ sich nicht bestimmen und nicht mit den %2 N/m vergleichen, die das Gerät ohne Schwingen wiedergibt: An jeder geprüften Stelle springt die Kraft oder nimmt nicht zu. Am Gerät prüfen, dass der Reiz kein Schwingen verursacht.</translation>
    </message>
    <message>
        <source>This holds for a moving mass of %1 g and a velocity delayed by %2 ms.</source>
        <translation>Das gilt für eine bewegte Masse von %1 g und eine um %2 ms verzögerte Geschwindigkeit.</translation>
    </message>
    <message>
        <source>This assumes a moving mass of %1 g, which was not measured, and a velocity delayed by %2 ms.</source>
        <translation>Das setzt eine bewegte Masse von %1 g voraus, die nicht gemessen wurde, und eine um %2 ms verzögerte Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Limit the normal force to %1 N, or lower the friction of the surface; even the greatest possible friction_speed_m_per_s is too low.</source>
        <translation>Die Normalkraft auf %1 N begrenzen oder die Reibung der Oberfläche verringern; selbst der größte zulässige Wert von friction_speed_m_per_s ist zu klein.</translation>
    </message>
    <message>
        <source>Set friction_speed_m_per_s to %1 or more, or limit the normal force to %2 N.</source>
        <translation>friction_speed_m_per_s auf mindestens %1 setzen oder die Normalkraft auf %2 N begrenzen.</translation>
    </message>
    <message>
        <source>Near rest, the friction of &quot;%1&quot; acts as a damper of %2 N s/m at a normal force of %3 N. At %4 Hz the device vibrates if the damping exceeds %5 N s/m: vibration is expected where strokes reverse. %6 %7</source>
        <translation>Nahe der Ruhe wirkt die Reibung von „%1“ bei einer Normalkraft von %3 N wie ein Dämpfer von %2 N s/m. Bei %4 Hz vibriert das Gerät, wenn die Dämpfung %5 N s/m übersteigt: An den Umkehrpunkten der Striche sind Vibrationen zu erwarten. %6 %7</translation>
    </message>
    <message>
        <source>The virtual coupling of &quot;%1&quot;, %2 N/m and %3 N s/m, requires a device with a damping of %4 N s/m at %5 Hz; the measured stiffness of this device corresponds to %6 N s/m. Lower coupling_damping_N_s_per_m or coupling_stiffness_N_per_m.</source>
        <translation>Die virtuelle Kopplung von „%1“, %2 N/m und %3 N s/m, erfordert ein Gerät mit einer Dämpfung von %4 N s/m bei %5 Hz; die gemessene Steifigkeit dieses Geräts entspricht %6 N s/m. coupling_damping_N_s_per_m oder coupling_stiffness_N_per_m verringern.</translation>
    </message>
    <message>
        <source>%1 The contact damping of %2 N s/m accounts for %3 N/m of this stiffness.</source>
        <translation>%1 Von dieser Steifigkeit entfallen %3 N/m auf die Kontaktdämpfung von %2 N s/m.</translation>
    </message>
    <message>
        <source>With a force of %2 N and a speed of %3 mm/s, contact with &quot;%1&quot; is expected to be lost for about %4 % of a stroke: a mass of %5 g with a damping of %6 N s/m, as measured for the device, cannot follow the height of the surface. Lower stiffness_N_per_m, the amplitude of the texture or the speed, or request a higher normal force.</source>
        <translation>Bei einer Kraft von %2 N und einer Geschwindigkeit von %3 mm/s ist zu erwarten, dass der Kontakt mit „%1“ für etwa %4 % eines Strichs verloren geht: Eine Masse von %5 g mit einer Dämpfung von %6 N s/m, wie am Gerät gemessen, folgt der Höhe der Oberfläche nicht. stiffness_N_per_m, die Amplitude der Textur oder die Geschwindigkeit verringern oder eine höhere Normalkraft vorgeben.</translation>
    </message>
    <message>
        <source>The smallest step of %1 in block %2 is %3 µm, which changes the force by %4 mN, but the force noise of the device at this stiffness is %5 mN. Use steps of at least %6 µm, or a device with less position noise.</source>
        <translation>Der kleinste Schritt von %1 im Block %2 beträgt %3 µm und ändert die Kraft um %4 mN, das Kraftrauschen des Geräts bei dieser Steifigkeit beträgt aber %5 mN. Schritte von mindestens %6 µm verwenden oder ein Gerät mit geringerem Positionsrauschen.</translation>
    </message>
    <message>
        <source>Set friction_mass_kg to %1 or less and friction_delay_s to %2 or more.</source>
        <translation>friction_mass_kg auf höchstens %1 und friction_delay_s auf mindestens %2 setzen.</translation>
    </message>
    <message>
        <source>Set friction_stiffness_N_per_m to %1 or less.</source>
        <translation>friction_stiffness_N_per_m auf höchstens %1 setzen.</translation>
    </message>
    <message>
        <source>Lower friction_damping_N_s_per_m and friction_stiffness_N_per_m, or choose a device with more damping.</source>
        <translation>friction_damping_N_s_per_m und friction_stiffness_N_per_m verringern oder ein Gerät mit mehr Dämpfung wählen.</translation>
    </message>
    <message>
        <source>Lower friction_smoothing_s and friction_stiffness_N_per_m, choose another friction_law, or choose a device with more damping.</source>
        <translation>friction_smoothing_s und friction_stiffness_N_per_m verringern, ein anderes friction_law oder ein Gerät mit mehr Dämpfung wählen.</translation>
    </message>
    <message>
        <source>Near rest, the friction of &quot;%1&quot; acts as a spring of %2 N/m whose force is delayed by %3 ms. At %4 Hz this requires a damping of %5 N s/m, but the damping of the device along the surface is %6 N s/m: vibration is expected where the hand rests or reverses, unless the hand adds the difference. %7</source>
        <translation>Nahe der Ruhe wirkt die Reibung von „%1“ wie eine Feder von %2 N/m, deren Kraft um %3 ms verzögert ist. Sie erfordert bei %4 Hz eine Dämpfung von %5 N s/m, die Dämpfung des Geräts entlang der Oberfläche beträgt aber %6 N s/m: Wo die Hand ruht oder umkehrt, sind Vibrationen zu erwarten, sofern die Hand die Differenz nicht ergänzt. %7</translation>
    </message>
    <message>
        <source>The friction of &quot;%1&quot; was not compared with the device. Near rest, it acts as a spring that requires a damping of %3 N s/m at %2 Hz, and the damping of the device is unknown. Measure the device, or state damping_N_s_per_m for a simulated device.</source>
        <translation>Die Reibung von „%1“ wurde nicht mit dem Gerät verglichen: Nahe der Ruhe wirkt sie wie eine Feder, die bei %2 Hz eine Dämpfung von %3 N s/m erfordert, und die Dämpfung des Geräts ist unbekannt. Das Gerät messen oder damping_N_s_per_m eines simulierten angeben.</translation>
    </message>
    <message>
        <source>%1 levels of %2 (%3)</source>
        <translation>%1 Stufen von %2 (%3)</translation>
    </message>
    <message>
        <source>%1 This kind of warning applies to %2; the one shown has the greatest difference.</source>
        <translation>%1 Eine solche Warnung gilt für %2; diese ist die mit der größten Differenz.</translation>
    </message>
    <message>
        <source>%1 The same applies to %2.</source>
        <translation>%1 Dasselbe gilt für %2.</translation>
    </message>
    <message>
        <source>Set stiffness_N_per_m to %1 or less, or choose a device with a finer position resolution.</source>
        <translation>stiffness_N_per_m auf höchstens %1 setzen oder ein Gerät mit feinerer Positionsauflösung wählen.</translation>
    </message>
    <message>
        <source>Set coupling_stiffness_N_per_m to %1 or less, or choose a device with a finer position resolution.</source>
        <translation>coupling_stiffness_N_per_m auf höchstens %1 setzen oder ein Gerät mit feinerer Positionsauflösung wählen.</translation>
    </message>
    <message>
        <source>Choose a softer surface, of %1 N/m or less, or a device with a finer position resolution.</source>
        <translation>Eine weichere Oberfläche mit höchstens %1 N/m oder ein Gerät mit feinerer Positionsauflösung wählen.</translation>
    </message>
    <message>
        <source>The device measures positions in steps of %2 µm. At the stiffness of &quot;%1&quot;, %3 N/m, one step changes the force by %4 mN, and a reading that varies between two steps is felt as a vibration; the threshold is about %5 mN. %6</source>
        <translation>Das Gerät misst Positionen in Schritten von %2 µm. Bei der Steifigkeit von „%1“, %3 N/m, ändert ein Schritt die Kraft um %4 mN, und ein Messwert, der zwischen zwei Schritten schwankt, ist als Vibration spürbar; die Schwelle liegt bei etwa %5 mN. %6</translation>
    </message>
    <message>
        <source>The texture of &quot;%1&quot; follows the path of the hand, and the position step of the device is unknown: if the step is greater than 10 µm, the path also grows while the hand rests. Measure the device, and set device_step_m to its position_resolution_m.</source>
        <translation>Die Textur von „%1“ folgt dem Weg der Hand, und der Positionsschritt des Geräts ist unbekannt: Ist er größer als 10 µm, wächst der Weg auch, während die Hand ruht. Das Gerät vermessen und device_step_m auf dessen position_resolution_m setzen.</translation>
    </message>
</context>
<context>
    <name>Renderings</name>
    <message>
        <source>This version has no force model “%1”. Load the plug-in that contains it, or choose another model in the workbench.</source>
        <translation>Diese Version hat kein Kraftmodell „%1“. Laden Sie das Plug-in, das es enthält, oder wählen Sie in der Werkstatt ein anderes Modell.</translation>
    </message>
    <message>
        <source>The force model “%1” had version %2 when the rendering was saved, and has version %3 now: its forces differ. Compare them in the workbench, and save the rendering again.</source>
        <translation>Das Kraftmodell „%1“ hatte Version %2, als die Wiedergabe gespeichert wurde, und hat jetzt Version %3: Seine Kräfte sind andere. In der Werkstatt vergleichen und die Wiedergabe neu speichern.</translation>
    </message>
    <message>
        <source>%1 has changed since the rendering was saved (another SHA-256). Restore the file, or choose the values again in the workbench and save a new rendering.</source>
        <translation>%1 wurde geändert, seit die Wiedergabe gespeichert wurde (anderer SHA-256). Die Datei wiederherstellen, oder die Werte in der Werkstatt neu wählen und eine neue Wiedergabe speichern.</translation>
    </message>
    <message>
        <source>The texture %1 cannot be read: %2. Restore the file, or save the rendering of another texture.</source>
        <translation>Die Textur %1 ist nicht lesbar: %2. Die Datei wiederherstellen, oder die Wiedergabe einer anderen Textur speichern.</translation>
    </message>
    <message>
        <source>This protocol shows pictures, and %1 has no photograph. Save the photograph as stimuli/%2_photo.png, or replace a surface and keep its texture.</source>
        <translation>Dieses Protokoll zeigt Bilder, und %1 hat kein Foto. Das Foto als stimuli/%2_photo.png speichern oder eine Oberfläche ersetzen und ihre Textur behalten.</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened. Open it again, then save the renderings.</source>
        <translation>%1 hat sich seit dem Öffnen geändert. Die Datei erneut öffnen, dann die Wiedergaben speichern.</translation>
    </message>
</context>
<context>
    <name>RunSession</name>
    <message>
        <source>the session last ran on %1 and is resumed on %2; this is stored with the session and stated in its report</source>
        <translation>die Sitzung lief zuletzt an %1 und wird an %2 fortgesetzt; das wird mit der Sitzung gespeichert und steht in ihrem Bericht</translation>
    </message>
    <message>
        <source>%1; choose another device, or relax the requirement in the protocol</source>
        <translation>%1; ein anderes Gerät wählen oder die Anforderung im Protokoll senken</translation>
    </message>
    <message>
        <source>the participant did not agree to take part, and nothing was stored; run the session with another participant</source>
        <translation>die Versuchsperson hat der Teilnahme nicht zugestimmt, und es wurde nichts gespeichert; die Sitzung mit einer anderen Versuchsperson durchführen</translation>
    </message>
    <message>
        <source>the new label &quot;%1&quot; differs from the label of the session&apos;s participant, %2; enter the label of that participant</source>
        <translation>das neue Kürzel „%1“ gehört nicht zur Versuchsperson der Sitzung, %2; das Kürzel dieser Versuchsperson eingeben</translation>
    </message>
    <message>
        <source>session %1 of participant %2 runs on a simulated clock; resume it without --realtime</source>
        <translation>Sitzung %1 der Versuchsperson %2 läuft mit simulierter Uhr; sie als schnelle Simulation fortsetzen</translation>
    </message>
    <message>
        <source>session %1 of participant %2 was begun in real time; resume it with --realtime</source>
        <translation>Sitzung %1 der Versuchsperson %2 wurde in Echtzeit begonnen; zum Fortsetzen Echtzeit wählen</translation>
    </message>
    <message>
        <source>participant %1 has an unfinished session %2 of this protocol; resume it with --resume</source>
        <translation>Sitzung %2 der Versuchsperson %1 mit diesem Protokoll ist unvollständig; zuerst diese fortsetzen</translation>
    </message>
    <message>
        <source>participant %1 has completed all sessions of this protocol (planned per participant: %2); choose another participant</source>
        <translation>die Versuchsperson %1 hat alle Sitzungen dieses Protokolls abgeschlossen (je Versuchsperson geplant: %2); eine andere Versuchsperson wählen</translation>
    </message>
    <message>
        <source>participant %1 is a virtual participant; use --virtual</source>
        <translation>%1 ist eine virtuelle Versuchsperson; zur Simulation wechseln</translation>
    </message>
    <message>
        <source>participant %1 is human; leave out --virtual, or use another label</source>
        <translation>die Versuchsperson %1 ist ein Mensch; für eine Simulation ein anderes Kürzel verwenden</translation>
    </message>
    <message>
        <source>participant %1 has withdrawn from the study; use another label</source>
        <translation>Versuchsperson %1 hat die Teilnahme an der Studie zurückgezogen; ein anderes Kürzel verwenden</translation>
    </message>
    <message>
        <source>%1; to resume it nevertheless, give the reason with --late-reason; the reason is stored and stated in the report</source>
        <translation>%1; um sie dennoch fortzusetzen, mit --late-reason den Grund angeben; der Grund wird gespeichert und im Bericht genannt</translation>
    </message>
    <message>
        <source>contacts cannot be evaluated on a GPU: %1 (on the command line: --compute cpu; in the protocol: device.compute)</source>
        <translation>Kontakte können nicht auf einer GPU berechnet werden: %1 (auf der Kommandozeile: --compute cpu; im Protokoll: device.compute)</translation>
    </message>
    <message>
        <source>no stimulus of the protocol %1 has a force model with two bodies, and only its contacts are evaluated on a GPU; leave out --compute or device.compute</source>
        <translation>kein Stimulus des Protokolls %1 hat ein Kraftmodell mit zwei Körpern, und nur deren Kontakte werden auf einer GPU berechnet; lassen Sie --compute oder device.compute weg</translation>
    </message>
</context>
<context>
    <name>SessionChecks</name>
    <message>
        <source>The file has changed since it was chosen: its SHA-256 was %1 and is now %2.</source>
        <translation>Die Datei hat sich seit der Auswahl geändert: Ihr SHA-256 war %1 und ist jetzt %2.</translation>
    </message>
    <message>
        <source>Choose the protocol again to read the new version, or restore the earlier file.</source>
        <translation>Das Protokoll erneut wählen, um die neue Fassung zu lesen, oder die frühere Datei wiederherstellen.</translation>
    </message>
    <message>
        <source>The protocol is valid: version %1, SHA-256 %2.</source>
        <translation>Das Protokoll ist gültig: Version %1, SHA-256 %2.</translation>
    </message>
    <message>
        <source>process %1 on host %2, started %3</source>
        <translation>Prozess %1 auf dem Rechner %2, gestartet %3</translation>
    </message>
    <message>
        <source>No participant has been chosen yet.</source>
        <translation>Es wurde noch keine Versuchsperson gewählt.</translation>
    </message>
    <message>
        <source>Choose a participant, or enter a new label.</source>
        <translation>Eine Versuchsperson wählen oder ein neues Kürzel eingeben.</translation>
    </message>
    <message>
        <source>Enter another label.</source>
        <translation>Ein anderes Kürzel eingeben.</translation>
    </message>
    <message>
        <source>A session of %1 is running in %2.</source>
        <translation>Eine Sitzung von %1 läuft bereits: %2.</translation>
    </message>
    <message>
        <source>Wait until it has ended, or stop it there.</source>
        <translation>Warten, bis sie beendet ist, oder sie dort stoppen.</translation>
    </message>
    <message>
        <source>%1 is a virtual participant.</source>
        <translation>%1 ist eine virtuelle Versuchsperson.</translation>
    </message>
    <message>
        <source>%1 is a human participant.</source>
        <translation>%1 ist eine menschliche Versuchsperson.</translation>
    </message>
    <message>
        <source>Choose a human participant, or switch to Simulate.</source>
        <translation>Eine menschliche Versuchsperson wählen oder zur Simulation wechseln.</translation>
    </message>
    <message>
        <source>Use the label that the program assigns, or switch to Run or Pilot.</source>
        <translation>Das vom Programm vergebene Kürzel verwenden oder zu „Erhebung“ oder „Pilot“ wechseln.</translation>
    </message>
    <message>
        <source>%1 has no unfinished session of this protocol in its present form.</source>
        <translation>%1 hat keine unvollständige Sitzung dieses Protokolls in seiner jetzigen Fassung.</translation>
    </message>
    <message>
        <source>Start a new session instead.</source>
        <translation>Stattdessen eine neue Sitzung starten.</translation>
    </message>
    <message>
        <source>Session %1 can be resumed.</source>
        <translation>Sitzung %1 kann fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Session %1 of this protocol is unfinished.</source>
        <translation>Sitzung %1 dieses Protokolls ist unvollständig.</translation>
    </message>
    <message>
        <source>Resume it; a new one can start when it is complete.</source>
        <translation>Diese Sitzung fortsetzen; eine neue kann beginnen, sobald diese vollständig ist.</translation>
    </message>
    <message>
        <source>%1 has completed all planned sessions (%2 of %3).</source>
        <translation>%1 hat alle geplanten Sitzungen abgeschlossen (%2 von %3).</translation>
    </message>
    <message>
        <source>Choose another participant.</source>
        <translation>Eine andere Versuchsperson wählen.</translation>
    </message>
    <message>
        <source>%1 is a participant of the study and has no session running elsewhere.</source>
        <translation>%1 ist Versuchsperson der Studie; keine ihrer Sitzungen läuft anderswo.</translation>
    </message>
    <message>
        <source>%1 is new and has no session running elsewhere.</source>
        <translation>%1 ist neu; keine Sitzung läuft anderswo.</translation>
    </message>
    <message>
        <source>The study folder is on a local disk and writable.</source>
        <translation>Der Studienordner liegt auf einem lokalen Datenträger und ist beschreibbar.</translation>
    </message>
    <message>
        <source>Move the study to a writable folder on a local disk.</source>
        <translation>Die Studie in einen beschreibbaren Ordner auf einem lokalen Datenträger verschieben.</translation>
    </message>
    <message>
        <source>The protocol uses no files.</source>
        <translation>Das Protokoll verwendet keine Dateien.</translation>
    </message>
    <message>
        <source>The protocol uses 1 file, which has not changed since the session began.</source>
        <translation>Das Protokoll verwendet 1 Datei, die seit Beginn der Sitzung unverändert ist.</translation>
    </message>
    <message>
        <source>The protocol uses 1 file, which is present and has not changed since it was made.</source>
        <translation>Das Protokoll verwendet 1 Datei, die vorhanden und unverändert ist.</translation>
    </message>
    <message>
        <source>The protocol uses %1 files, which have not changed since the session began.</source>
        <translation>Das Protokoll verwendet %1 Dateien, die seit Beginn der Sitzung unverändert sind.</translation>
    </message>
    <message>
        <source>The protocol uses %1 files, which are present and have not changed since they were made.</source>
        <translation>Das Protokoll verwendet %1 Dateien, die vorhanden und unverändert sind.</translation>
    </message>
    <message>
        <source>Restore the files in the study, or make them again.</source>
        <translation>Die Dateien in der Studie wiederherstellen oder neu erzeugen.</translation>
    </message>
    <message>
        <source>The file %1 has changed since session %2 began.</source>
        <translation>Die Datei %1 hat sich seit Beginn der Sitzung %2 geändert.</translation>
    </message>
    <message>
        <source>Restore the earlier file; this session cannot be resumed with a different file.</source>
        <translation>Die frühere Datei wiederherstellen; mit einer anderen kann diese Sitzung nicht fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Choose another device, or lower the requirements in the protocol.</source>
        <translation>Ein anderes Gerät wählen oder die Anforderungen im Protokoll senken.</translation>
    </message>
    <message>
        <source>Not needed: no handle is held in a fast simulation.</source>
        <translation>Nicht nötig: In einer schnellen Simulation wird kein Griff gehalten.</translation>
    </message>
    <message>
        <source>Not needed: a fast simulation has its own clock.</source>
        <translation>Nicht nötig: Eine schnelle Simulation hat ihre eigene Uhr.</translation>
    </message>
    <message>
        <source>The device reported a fault: %1.</source>
        <translation>Das Gerät meldet eine Störung: %1.</translation>
    </message>
    <message>
        <source>Fix the problem with the device, then check again.</source>
        <translation>Das Problem am Gerät beheben, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>A force of %1 N was sent although no surface was presented.</source>
        <translation>Eine Kraft von %1 N wurde gesendet, obwohl keine Oberfläche dargeboten wurde.</translation>
    </message>
    <message>
        <source>Release the handle, switch the device off and on, then check again.</source>
        <translation>Den Griff loslassen, das Gerät aus- und einschalten, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Exactly 0 N was sent in %1 ticks.</source>
        <translation>In %1 Takten wurden genau 0 N gesendet.</translation>
    </message>
    <message>
        <source>%1 of %2 Hz; period p99 %3, lateness p99 %4, missed deadlines: %5.</source>
        <translation>%1 von %2 Hz; Periode p99 %3, Verspätung p99 %4, verpasste Fristen: %5.</translation>
    </message>
    <message>
        <source>This computer is too slow or too busy: close other programs, then check again.</source>
        <translation>Dieser Rechner ist zu langsam oder zu stark ausgelastet: andere Programme schließen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Close other programs. An attempt does not count if the number of missed deadlines exceeds %1.</source>
        <translation>Andere Programme schließen. Ein Versuch zählt nicht, wenn die Anzahl verpasster Fristen %1 übersteigt.</translation>
    </message>
    <message>
        <source>Not needed: no participant looks at the participant&apos;s window.</source>
        <translation>Nicht nötig: Keine Versuchsperson sieht das Fenster der Versuchsperson.</translation>
    </message>
    <message>
        <source>%1 screens: one for each window.</source>
        <translation>%1 Bildschirme: einer für jedes Fenster.</translation>
    </message>
    <message>
        <source>One screen: the two windows are side by side, and the participant can see both.</source>
        <translation>Ein Bildschirm: Beide Fenster stehen nebeneinander, und die Versuchsperson kann beide sehen.</translation>
    </message>
    <message>
        <source>Connect a second screen for the participant.</source>
        <translation>Einen zweiten Bildschirm für die Versuchsperson anschließen.</translation>
    </message>
    <message>
        <source>The protocol requires no masking noise.</source>
        <translation>Das Protokoll verlangt kein Maskierrauschen.</translation>
    </message>
    <message>
        <source>Not needed: no participant listens.</source>
        <translation>Nicht nötig: Keine Versuchsperson hört zu.</translation>
    </message>
    <message>
        <source>It is not stated who measured the level at the ear.</source>
        <translation>Es ist nicht angegeben, wer den Pegel am Ohr gemessen hat.</translation>
    </message>
    <message>
        <source>The level at the ear was not measured.</source>
        <translation>Der Pegel am Ohr wurde nicht gemessen.</translation>
    </message>
    <message>
        <source>Play the noise, measure it at the ear, and enter the level and your name.</source>
        <translation>Das Rauschen abspielen, am Ohr messen und Pegel und Namen eintragen.</translation>
    </message>
    <message>
        <source>%1 dB(A) at the ear; the protocol requires %2 ± %3 dB(A).</source>
        <translation>%1 dB(A) am Ohr; das Protokoll verlangt %2 ± %3 dB(A).</translation>
    </message>
    <message>
        <source>Change the gain and measure again.</source>
        <translation>Die Verstärkung ändern und erneut messen.</translation>
    </message>
    <message>
        <source>%1 dB(A) at the ear, verified by %2.</source>
        <translation>%1 dB(A) am Ohr, geprüft von %2.</translation>
    </message>
    <message>
        <source>The free space cannot be determined: %1.</source>
        <translation>Der freie Speicherplatz ließ sich nicht bestimmen: %1.</translation>
    </message>
    <message>
        <source>Make sure that the disk has room for the recordings.</source>
        <translation>Sicherstellen, dass auf dem Datenträger genug Platz für die Aufzeichnungen ist.</translation>
    </message>
    <message>
        <source>Fix the problem, then check again.</source>
        <translation>Das Problem beheben, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Versuchsperson</translation>
    </message>
    <message>
        <source>Study folder</source>
        <translation>Studienordner</translation>
    </message>
    <message>
        <source>Disk space</source>
        <translation>Speicherplatz</translation>
    </message>
    <message>
        <source>Stimuli</source>
        <translation>Reize</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Not needed: the simulated device has no calibration.</source>
        <translation>Nicht nötig: Das simulierte Gerät hat keine Kalibrierung.</translation>
    </message>
    <message>
        <source>Force zero</source>
        <translation>Kraft null</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Taktrate</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>Bildschirme</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>Maskierrauschen</translation>
    </message>
    <message>
        <source>%1 free; this session requires at most %2.</source>
        <translation>%1 frei; diese Sitzung braucht höchstens %2.</translation>
    </message>
    <message>
        <source>Free some space on the disk of the study.</source>
        <translation>Platz auf dem Datenträger der Studie schaffen.</translation>
    </message>
    <message>
        <source>The space is sufficient for this session, but hardly for another one. Free some space soon.</source>
        <translation>Der Platz reicht für diese Sitzung, aber kaum für eine weitere. Bald Platz schaffen.</translation>
    </message>
    <message>
        <source>the protocol %1 has changed since it was checked: its SHA-256 was %2 and is now %3; choose it again to read and check the new version</source>
        <translation>das Protokoll %1 hat sich seit der Prüfung geändert: Sein SHA-256 war %2 und ist jetzt %3; es erneut wählen, um die neue Fassung zu lesen und zu prüfen</translation>
    </message>
    <message>
        <source>There is no sound output: a participant who wears an eye mask hears no cues.</source>
        <translation>Es gibt keine Tonausgabe: Eine Versuchsperson mit Augenbinde hört keine Signale.</translation>
    </message>
    <message>
        <source>Connect headphones, then check again; or guide the participant by voice.</source>
        <translation>Kopfhörer anschließen, dann erneut prüfen; oder die Versuchsperson mit der Stimme führen.</translation>
    </message>
    <message>
        <source>There is no sound output: the noise that the protocol requires cannot be heard.</source>
        <translation>Es gibt keine Tonausgabe: Das vom Protokoll verlangte Rauschen ist nicht zu hören.</translation>
    </message>
    <message>
        <source>Connect headphones, then check again; or play the noise from another source, measure it at the ear, and enter the level and your name.</source>
        <translation>Kopfhörer anschließen, dann erneut prüfen; oder das Rauschen aus einer anderen Quelle abspielen, am Ohr messen und Pegel und Namen eintragen.</translation>
    </message>
    <message>
        <source>There is no sound output here; the noise comes from another source, %1 dB(A) at the ear, verified by %2.</source>
        <translation>Hier gibt es keine Tonausgabe; das Rauschen kommt aus einer anderen Quelle, %1 dB(A) am Ohr, geprüft von %2.</translation>
    </message>
    <message>
        <source>There is no sound output: the tones by which the protocol guides the hand cannot be heard, and silence would indicate that force and speed are correct.</source>
        <translation>Es gibt keine Tonausgabe: Die Töne, mit denen das Protokoll die Hand führt, sind nicht zu hören, und Stille würde anzeigen, dass Kraft und Geschwindigkeit richtig sind.</translation>
    </message>
    <message>
        <source>Connect headphones, then check again.</source>
        <translation>Kopfhörer anschließen, dann erneut prüfen.</translation>
    </message>
    <message>
        <source>Fix the problem, then try the device again.</source>
        <translation>Das Problem beheben, dann das Gerät erneut ausprobieren.</translation>
    </message>
    <message>
        <source>Rehearsal</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>%1 Further warnings of this kind: %2.</source>
        <translation>%1 Weitere Warnungen dieser Art: %2.</translation>
    </message>
    <message>
        <source>Choose another device, or stimuli that this one can render; otherwise these warnings are stored with the session.</source>
        <translation>Ein anderes Gerät wählen oder Reize, die dieses wiedergeben kann; andernfalls werden diese Warnungen mit der Sitzung gespeichert.</translation>
    </message>
    <message>
        <source>Not needed: the device exerts no force.</source>
        <translation>Nicht nötig: Das Gerät übt keine Kraft aus.</translation>
    </message>
    <message>
        <source>The study has no profile of this device, so it was not checked whether the device can render these stimuli.</source>
        <translation>Die Studie hat kein Profil dieses Geräts: Ob es diese Reize wiedergeben kann, wurde nicht geprüft.</translation>
    </message>
    <message>
        <source>%1; every stimulus is within the capabilities of the device.</source>
        <translation>%1; jeder Reiz liegt im Leistungsbereich des Geräts.</translation>
    </message>
    <message>
        <source>%1; some stimuli exceed the capabilities of the device.</source>
        <translation>%1; einige Reize liegen außerhalb des Leistungsbereichs des Geräts.</translation>
    </message>
    <message>
        <source>%1 The device failed an item of the measurement.</source>
        <translation>%1 Das Gerät hat einen Punkt der Messung nicht bestanden.</translation>
    </message>
    <message>
        <source>Check the profile of the device, and measure the device again.</source>
        <translation>Das Profil des Geräts prüfen und das Gerät erneut messen.</translation>
    </message>
    <message>
        <source>Measure the device once while its handle is not held: asperity device-test &quot;%1&quot; --study &quot;%2&quot;</source>
        <translation>Das Gerät einmal messen, während sein Griff nicht gehalten wird: asperity device-test &quot;%1&quot; --study &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1; every stimulus is within the capabilities of the device, but the device does not meet the protocol&apos;s limits.</source>
        <translation>%1; jeder Reiz liegt im Leistungsbereich des Geräts, aber es hält die Grenzwerte des Protokolls nicht ein.</translation>
    </message>
    <message>
        <source>%1 Unknown for %2 and not compared: %3.</source>
        <translation>%1 Unbekannt für %2 und nicht verglichen: %3.</translation>
    </message>
    <message>
        <source>%1; every stimulus is within the known capabilities of the device, but the device does not meet the protocol&apos;s limits.</source>
        <translation>%1; jeder Reiz liegt im bekannten Leistungsbereich des Geräts, aber es hält die Grenzwerte des Protokolls nicht ein.</translation>
    </message>
    <message>
        <source>%1; every stimulus is within the known capabilities of the device.</source>
        <translation>%1; jeder Reiz liegt im bekannten Leistungsbereich des Geräts.</translation>
    </message>
    <message>
        <source>Measure a real device as soon as one is available.</source>
        <translation>Ein echtes Gerät messen, sobald eines verfügbar ist.</translation>
    </message>
    <message>
        <source>Choose the device on which the session last ran, unless a change is intended; a change is stored and stated in the report.</source>
        <translation>Das Gerät wählen, an dem die Sitzung zuletzt lief, sofern kein Wechsel beabsichtigt ist; ein Wechsel wird gespeichert und im Bericht genannt.</translation>
    </message>
    <message>
        <source>The study folder is on a local disk and writable. Every user of this computer can read it.</source>
        <translation>Der Studienordner liegt auf einem lokalen Datenträger und ist beschreibbar. Jeder Benutzer dieses Rechners kann ihn lesen.</translation>
    </message>
    <message>
        <source>To keep other users out, run: %1</source>
        <translation>Befehl, der andere Benutzer ausschließt: %1</translation>
    </message>
    <message>
        <source>%1 has withdrawn.</source>
        <translation>%1 hat die Teilnahme zurückgezogen.</translation>
    </message>
    <message>
        <source>Enter the reason for resuming it.</source>
        <translation>Den Grund für die Fortsetzung eingeben.</translation>
    </message>
    <message>
        <source>The reason is stored and stated in the report.</source>
        <translation>Der Grund wird gespeichert und im Bericht genannt.</translation>
    </message>
    <message>
        <source>“%1” has not been tried yet.</source>
        <translation>„%1“ wurde noch nicht ausprobiert.</translation>
    </message>
    <message>
        <source>Press “Try this device” while its handle is not held: the device is opened, and the servo loop runs for a third of a second without force.</source>
        <translation>„Dieses Gerät ausprobieren“ drücken, während der Griff nicht gehalten wird: Das Gerät wird geöffnet, und die Servoschleife läuft eine Drittelsekunde lang ohne Kraft.</translation>
    </message>
    <message>
        <source>“%1” moves and presses the probe but exerts no force: the participant feels nothing.</source>
        <translation>„%1“ bewegt und drückt den Taster, übt aber keine Kraft aus: Die Versuchsperson fühlt nichts.</translation>
    </message>
    <message>
        <source>“%1” exerts up to %2 N at up to %3 Hz; the protocol requires %4 N at %5 Hz.</source>
        <translation>„%1“ übt bis zu %2 N bei bis zu %3 Hz aus; das Protokoll verlangt %4 N bei %5 Hz.</translation>
    </message>
    <message>
        <source>%1 The session last ran on “%2”.</source>
        <translation>%1 Die Sitzung lief zuletzt an „%2“.</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Gemessen %1</translation>
    </message>
    <message>
        <source>Fix the problem, then press “Rescan”; or choose another device.</source>
        <translation>Das Problem beheben, dann „Erneut suchen“ drücken; oder ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>The Protocols page lists all warnings.</source>
        <translation>Die Seite „Protokolle“ nennt alle Warnungen.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Warnings about the stimuli</source>
        <translation>Warnungen zu den Reizen</translation>
    </message>
</context>
<context>
    <name>SessionEnd</name>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>incorrect</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>last − first: %1</source>
        <translation>letzte − erste: %1</translation>
    </message>
    <message>
        <source>last/first: %1</source>
        <translation>letzte/erste: %1</translation>
    </message>
    <message>
        <source>Anchors of block %1 (%2), question %3: %4.</source>
        <translation>Anker des Blocks %1 (%2), Frage %3: %4.</translation>
    </message>
    <message>
        <source>Anchors of block %1 (%2), question %3: %4; %5.</source>
        <translation>Anker des Blocks %1 (%2), Frage %3: %4; %5.</translation>
    </message>
</context>
<context>
    <name>SessionLanguage</name>
    <message>
        <source>the earlier sessions of participant %1 were in the language &quot;%2&quot; and this one would be in &quot;%3&quot;; all sessions of a participant are in one language: choose &quot;%2&quot;, or another participant</source>
        <translation>die früheren Sitzungen der Versuchsperson %1 waren in der Sprache „%2“, und diese wäre in „%3“; alle Sitzungen einer Versuchsperson sind in einer Sprache: „%2“ oder eine andere Versuchsperson wählen</translation>
    </message>
</context>
<context>
    <name>SessionSetup</name>
    <message>
        <source>the protocol &quot;%1&quot; names the file %2, which is not in the study %3; copy the file into the study</source>
        <translation>das Protokoll „%1“ verwendet die Datei %2, die nicht in der Studie %3 liegt; die Datei in die Studie kopieren</translation>
    </message>
    <message>
        <source>session %1 of participant %2 cannot be resumed: the plan that this program makes from its protocol differs from the stored one. Resume it with the version with which it began: asperity %3, commit %4</source>
        <translation>Sitzung %1 der Versuchsperson %2 kann nicht fortgesetzt werden: Der Plan, den dieses Programm aus ihrem Protokoll erzeugt, weicht vom gespeicherten ab. Die Sitzung mit der Version fortsetzen, mit der sie begann: asperity %3, Commit %4</translation>
    </message>
    <message>
        <source>session %1 of participant %2 cannot be resumed: the file %3 has changed since the session began; restore the earlier file</source>
        <translation>Sitzung %1 der Versuchsperson %2 kann nicht fortgesetzt werden: Die Datei %3 hat sich seit Beginn der Sitzung geändert; die frühere Datei wiederherstellen</translation>
    </message>
    <message>
        <source>participant %1 has no unfinished session of the protocol &quot;%2&quot; in its present form; leave out --resume to begin one</source>
        <translation>die Versuchsperson %1 hat keine unvollständige Sitzung des Protokolls „%2“ in der Fassung dieser Datei; eine neue beginnen</translation>
    </message>
    <message>
        <source>equal force is requested with the model &quot;%1&quot;, which this program does not have; use one that &quot;asperity models&quot; lists</source>
        <translation>das Protokoll verlangt gleiche Kraft mit dem Modell „%1“, das dieses Programm nicht hat; eines verwenden, das „asperity models“ auflistet</translation>
    </message>
    <message>
        <source>the stimulus &quot;%1&quot; has a relative amplitude, but its force model &quot;%2&quot; has no amplitude; use a model that has one</source>
        <translation>der Reiz „%1“ hat eine relative Amplitude, aber sein Kraftmodell „%2“ hat keine Amplitude; verwenden Sie ein Modell, das eine hat</translation>
    </message>
    <message>
        <source>the stimulus &quot;%1&quot; at a relative amplitude of %2: %3 Narrow the range of the relative amplitude.</source>
        <translation>der Reiz „%1“ bei einer relativen Amplitude von %2: %3 Verkleinern Sie den Bereich der relativen Amplitude.</translation>
    </message>
    <message>
        <source>the stimulus &quot;%1&quot; needs the force model &quot;%2&quot;, which this program does not have; load its plug-in, or use one that &quot;asperity models&quot; lists</source>
        <translation>der Reiz „%1“ braucht das Kraftmodell „%2“, das dieses Programm nicht hat; sein Plug-in laden oder eines verwenden, das „asperity models“ auflistet</translation>
    </message>
</context>
<context>
    <name>SessionText</name>
    <message>
        <source>The session has not begun</source>
        <translation>Die Sitzung hat noch nicht begonnen</translation>
    </message>
    <message>
        <source>Preparation: the participant is reading, or the device is being checked</source>
        <translation>Vorbereitung: Die Versuchsperson liest, oder das Gerät wird geprüft</translation>
    </message>
    <message>
        <source>Between trials; next: trial %1</source>
        <translation>Zwischen Durchgängen; als Nächstes: Durchgang %1</translation>
    </message>
    <message>
        <source>Between trials</source>
        <translation>Zwischen Durchgängen</translation>
    </message>
    <message>
        <source>Trial %1: waiting for the first touch, %2 s</source>
        <translation>Durchgang %1: wartet auf die erste Berührung, %2 s</translation>
    </message>
    <message>
        <source>Trial %1: feeling surface %2 of %3 (%4), %5 s</source>
        <translation>Durchgang %1: fühlt Oberfläche %2 von %3 (%4), %5 s</translation>
    </message>
    <message>
        <source>Trial %1: feeling %2, %3 s</source>
        <translation>Durchgang %1: fühlt %2, %3 s</translation>
    </message>
    <message>
        <source>Trial %1: answering, %2 s</source>
        <translation>Durchgang %1: antwortet, %2 s</translation>
    </message>
    <message>
        <source>Trial %1: feedback</source>
        <translation>Durchgang %1: Rückmeldung</translation>
    </message>
    <message>
        <source>Break, %1</source>
        <translation>Pause, %1</translation>
    </message>
    <message>
        <source>The participant is answering questions</source>
        <translation>Die Versuchsperson beantwortet Fragen</translation>
    </message>
    <message>
        <source>Paused before trial %1</source>
        <translation>Angehalten vor Durchgang %1</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Stopped: the force is held at zero</source>
        <translation>Gestoppt: Die Kraft wird auf null gehalten</translation>
    </message>
    <message>
        <source>The session has ended</source>
        <translation>Die Sitzung ist zu Ende</translation>
    </message>
    <message>
        <source>waiting for touch %1 s</source>
        <translation>wartet auf Berührung %1 s</translation>
    </message>
    <message>
        <source>feeling %1 s</source>
        <translation>fühlt %1 s</translation>
    </message>
    <message>
        <source>answering %1 s</source>
        <translation>antwortet %1 s</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>paused before this trial</source>
        <translation>vor diesem Durchgang angehalten</translation>
    </message>
    <message>
        <source>after the break</source>
        <translation>nach der Pause</translation>
    </message>
    <message>
        <source>next</source>
        <translation>als Nächstes</translation>
    </message>
    <message>
        <source>%1, not counted</source>
        <translation>%1, nicht gezählt</translation>
    </message>
    <message>
        <source>%1, flagged</source>
        <translation>%1, markiert</translation>
    </message>
    <message>
        <source>RUN</source>
        <translation>ERHEBUNG</translation>
    </message>
    <message>
        <source>PILOT</source>
        <translation>PILOT</translation>
    </message>
    <message>
        <source>SIMULATE</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>less than a minute left</source>
        <translation>Restzeit unter einer Minute</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>Restzeit etwa %1 min</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>less than a minute, until %1</source>
        <translation>weniger als eine Minute, bis %1</translation>
    </message>
    <message>
        <source>about %1 min, until %2</source>
        <translation>etwa %1 min, bis %2</translation>
    </message>
    <message>
        <source>time left: –</source>
        <translation>Restzeit: –</translation>
    </message>
    <message>
        <source>After the last trial: the participant is reading</source>
        <translation>Nach dem letzten Durchgang: Die Versuchsperson liest</translation>
    </message>
    <message>
        <source>Resume this session…</source>
        <translation>Diese Sitzung fortsetzen…</translation>
    </message>
    <message>
        <source>%1, correct</source>
        <translation>%1, richtig</translation>
    </message>
    <message>
        <source>%1, incorrect</source>
        <translation>%1, falsch</translation>
    </message>
    <message>
        <source>Trial %1: feeling %2 surfaces side by side, %3 s</source>
        <translation>Durchgang %1: fühlt %2 Oberflächen nebeneinander, %3 s</translation>
    </message>
    <message>
        <source>Repeated practice: %1</source>
        <translation>Wiederholte Übung: %1</translation>
    </message>
    <message>
        <source>Repeated practice: feedback</source>
        <translation>Wiederholte Übung: Rückmeldung</translation>
    </message>
    <message>
        <source>%1, practised again</source>
        <translation>%1, wiederholte Übung</translation>
    </message>
</context>
<context>
    <name>Simulation</name>
    <message>
        <source>the simulation was stopped on request; every completed trial is stored; to resume it, add --resume to the same arguments</source>
        <translation>die Simulation wurde auf Wunsch gestoppt; jeder abgeschlossene Durchgang ist gespeichert; um sie fortzusetzen, fügen Sie denselben Angaben --resume hinzu</translation>
    </message>
    <message>
        <source>the simulation was stopped on request; every completed trial is stored; to resume it, start it again with the same arguments</source>
        <translation>die Simulation wurde auf Wunsch gestoppt; jeder abgeschlossene Durchgang ist gespeichert; um sie fortzusetzen, starten Sie sie noch einmal mit denselben Angaben</translation>
    </message>
    <message>
        <source>the simulation in %3 (participants: %1, seed: %2) is not complete; to complete it, add --resume; to add further participants, use another --seed. No participant was added</source>
        <translation>die Simulation in %3 (Versuchspersonen: %1, Startwert: %2) ist nicht abgeschlossen; um sie abzuschließen, --resume angeben; um weitere Versuchspersonen hinzuzufügen, einen anderen --seed wählen. Es wurde keine Versuchsperson hinzugefügt</translation>
    </message>
    <message>
        <source>the protocols %1 and %2 differ in device.compute; state --compute, or simulate them one after the other</source>
        <translation>die Protokolle %1 und %2 unterscheiden sich in device.compute; geben Sie --compute an, oder simulieren Sie sie nacheinander</translation>
    </message>
    <message>
        <source>the session of %1 with &quot;%2&quot; stopped: %3; every completed trial is stored</source>
        <translation>die Sitzung von %1 mit „%2“ wurde gestoppt: %3; jeder abgeschlossene Durchgang ist gespeichert</translation>
    </message>
</context>
<context>
    <name>StepWords</name>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Graustufen</translation>
    </message>
    <message>
        <source>Evened lighting</source>
        <translation>Ausgeglichenes Licht</translation>
    </message>
    <message>
        <source>Long wavelengths</source>
        <translation>Große Wellenlängen</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>The photograph, unchanged.</source>
        <translation>Das Foto, unverändert.</translation>
    </message>
    <message>
        <source>Its brightness only; with “Equalized”, after histogram equalisation.</source>
        <translation>Nur seine Helligkeit; mit „Egalisiert“ nach dem Histogrammausgleich.</translation>
    </message>
    <message>
        <source>Gradual changes of lighting are attenuated and fine detail is amplified.</source>
        <translation>Allmähliche Änderungen der Beleuchtung werden abgeschwächt, feine Details verstärkt.</translation>
    </message>
    <message>
        <source>Wavelengths longer than the longest one kept; they are subtracted from the previous step.</source>
        <translation>Wellenlängen oberhalb der größten erhaltenen Wellenlänge; sie werden vom vorigen Schritt abgezogen.</translation>
    </message>
    <message>
        <source>The remainder, as heights: dark is low, bright is high.</source>
        <translation>Der Rest, als Höhen: Dunkel ist tief, hell ist hoch.</translation>
    </message>
    <message>
        <source>The heights as an illuminated surface.</source>
        <translation>Die Höhen als beleuchtete Oberfläche.</translation>
    </message>
</context>
<context>
    <name>StimulusFiles</name>
    <message>
        <source>%1 names %2 and cannot be changed, because it is not valid JSON. Fix the file first.</source>
        <translation>%1 nennt %2 und kann nicht geändert werden, weil die Datei kein gültiges JSON ist. Zuerst die Datei berichtigen.</translation>
    </message>
    <message>
        <source>%1 belongs to stored sessions, which refer to its name and its content. It can be neither renamed nor deleted.</source>
        <translation>%1 gehört zu gespeicherten Sitzungen, die sich auf Namen und Inhalt beziehen. Umbenennen und Löschen sind nicht möglich.</translation>
    </message>
    <message>
        <source>%1 is used by %2. Remove it there before you delete it.</source>
        <translation>%1 wird von %2 verwendet. Vor dem Löschen dort entfernen.</translation>
    </message>
    <message>
        <source>The study already has a file %1. Choose another name.</source>
        <translation>Die Studie hat bereits eine Datei %1. Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1 is not a study. Choose the folder of a study.</source>
        <translation>%1 ist keine Studie. Den Ordner einer Studie wählen.</translation>
    </message>
    <message>
        <source>%1 has been changed meanwhile, and nothing was renamed. Rename the stimulus again.</source>
        <translation>%1 wurde inzwischen geändert, und nichts wurde umbenannt. Den Reiz noch einmal umbenennen.</translation>
    </message>
    <message>
        <source>“%1” cannot be the name of a stimulus. Use at most %2 unaccented letters, digits, _ and -.</source>
        <translation>„%1“ kann nicht der Name eines Reizes sein. Erlaubt sind höchstens %2 Buchstaben ohne Akzente, Ziffern, _ und -.</translation>
    </message>
    <message>
        <source>%1 is used by protocols with stored sessions: %2. Remove it there first.</source>
        <translation>%1 wird von Protokollen mit gespeicherten Sitzungen verwendet: %2. Zuerst dort entfernen.</translation>
    </message>
</context>
<context>
    <name>StimulusTable</name>
    <message>
        <source>%1, the height field of the stimulus %2, is missing from the study: the export has neither the file nor its features. Restore it from a backup or a copy of the study, then export again.</source>
        <translation>%1, das Höhenfeld des Reizes %2, fehlt in der Studie: Der Export enthält weder die Datei noch ihre Merkmale. Die Datei aus einer Sicherung oder einer Kopie der Studie wiederherstellen, dann erneut exportieren.</translation>
    </message>
    <message>
        <source>%1, the height field of the stimulus %2, is not the file that the sessions used: the export has neither that file nor its features. Restore it from a backup or a copy of the study, then export again.</source>
        <translation>%1, das Höhenfeld des Reizes %2, ist nicht die Datei, die in den Sitzungen verwendet wurde: Der Export enthält weder diese Datei noch ihre Merkmale. Die Datei aus einer Sicherung oder einer Kopie der Studie wiederherstellen, dann erneut exportieren.</translation>
    </message>
</context>
<context>
    <name>StudyData</name>
    <message>
        <source>a virtual hand holds the device &quot;%1&quot;, so that no participant would feel the surfaces</source>
        <translation>eine virtuelle Hand hält das Gerät „%1“, sodass keine Versuchsperson die Oberflächen fühlen würde</translation>
    </message>
    <message>
        <source>a recorded hand holds the device &quot;%1&quot;, so that no participant would feel the surfaces</source>
        <translation>eine aufgezeichnete Hand hält das Gerät „%1“, sodass keine Versuchsperson die Oberflächen fühlen würde</translation>
    </message>
    <message>
        <source>the device &quot;%1&quot; has no motors, so that no participant would feel the surfaces</source>
        <translation>das Gerät „%1“ hat keine Motoren, sodass keine Versuchsperson die Oberflächen fühlen würde</translation>
    </message>
    <message>
        <source>%1; %2 (Pilot: --mode pilot)</source>
        <translation>%1; %2 (Pilot: --mode pilot)</translation>
    </message>
    <message>
        <source>try the session out in Pilot, or choose a device that a participant holds</source>
        <translation>die Sitzung im Modus „Pilot“ ausprobieren oder ein Gerät wählen, das von einer Versuchsperson gehalten wird</translation>
    </message>
    <message>
        <source>try the session out in Pilot, or choose a device with motors; if the study needs no force, set device.input_only to true in the protocol, which allows a device without motors</source>
        <translation>die Sitzung im Modus „Pilot“ ausprobieren oder ein Gerät mit Motoren wählen; wenn die Studie keine Kraft braucht, im Protokoll device.input_only auf true setzen, was ein Gerät ohne Motoren erlaubt</translation>
    </message>
</context>
<context>
    <name>StudyExport</name>
    <message>
        <source>The study has no sessions, so that there are no files for other programs; run a session, then export again.</source>
        <translation>Die Studie hat keine Sitzungen, sodass es keine Dateien für andere Programme gibt; eine Sitzung durchführen, dann erneut exportieren.</translation>
    </message>
    <message>
        <source>The labels %1 and %2 differ only in letter case or leading zeros: some programs and file systems take them for one. If they are of one participant, state this where the data are used.</source>
        <translation>Die Kürzel %1 und %2 unterscheiden sich nur in der Groß- und Kleinschreibung oder in führenden Nullen: Manche Programme und Dateisysteme halten sie für dasselbe. Falls sie zu einer Versuchsperson gehören, dies angeben, wo die Daten verwendet werden.</translation>
    </message>
</context>
<context>
    <name>StudyMetadata</name>
    <message>
        <source>The study has neither authors nor a licence; data archives require both.</source>
        <translation>Für die Studie sind weder Autorinnen und Autoren noch eine Lizenz angegeben; Datenarchive verlangen beides.</translation>
    </message>
    <message>
        <source>The study has no authors; data archives require them.</source>
        <translation>Für die Studie sind keine Autorinnen und Autoren angegeben; Datenarchive verlangen sie.</translation>
    </message>
    <message>
        <source>The study has no licence; data archives require one.</source>
        <translation>Für die Studie ist keine Lizenz angegeben; Datenarchive verlangen eine.</translation>
    </message>
</context>
<context>
    <name>StudyOutputs</name>
    <message>
        <source>The study is read-only: it does not list %1 among its outputs. Keep a note of it in case a participant withdraws.</source>
        <translation>Die Studie ist schreibgeschützt: %1 ist nicht unter ihren Ausgaben verzeichnet. Diese Ausgabe notieren, für den Fall, dass eine Versuchsperson die Teilnahme zurückzieht.</translation>
    </message>
    <message>
        <source>%1 is complete, but the study does not list it; keep a note of it in case a participant withdraws. The reason is: %2</source>
        <translation>%1 ist vollständig, aber nicht in der Studie verzeichnet; diese Ausgabe notieren, für den Fall, dass eine Versuchsperson die Teilnahme zurückzieht. Der Grund: %2</translation>
    </message>
    <message>
        <source>export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>public export</source>
        <translation>Export zur Veröffentlichung</translation>
    </message>
    <message>
        <source>report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>copy of the study</source>
        <translation>Kopie der Studie</translation>
    </message>
    <message>
        <source>merged study</source>
        <translation>zusammengeführte Studie</translation>
    </message>
</context>
<context>
    <name>StudyProtocols</name>
    <message>
        <source>Sessions of %1 are stored (number: %2); they refer to its name and its text. Duplicate the protocol, and change the copy.</source>
        <translation>Von %1 sind Sitzungen gespeichert (Anzahl: %2); sie beziehen sich auf Namen und Text. Das Protokoll duplizieren und die Kopie ändern.</translation>
    </message>
    <message>
        <source>“%1” cannot be the name of a protocol. Use lower-case letters, digits and underscores, beginning with a letter.</source>
        <translation>„%1“ kann nicht der Name eines Protokolls sein. Nur Kleinbuchstaben, Ziffern und Unterstriche verwenden und mit einem Buchstaben beginnen.</translation>
    </message>
    <message>
        <source>The study already has a file %1. Choose another name.</source>
        <translation>Die Studie hat bereits eine Datei %1. Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Sessions of a protocol called %1 are stored in this study. Choose another name.</source>
        <translation>In dieser Studie sind Sitzungen eines Protokolls mit dem Namen %1 gespeichert. Einen anderen Namen wählen.</translation>
    </message>
</context>
<context>
    <name>TestMethods</name>
    <message>
        <source>exact binomial test, one-sided</source>
        <translation>exakter Binomialtest, einseitig</translation>
    </message>
    <message>
        <source>permutation test, pictures relabelled per participant, one-sided</source>
        <translation>Permutationstest, Bilder je Versuchsperson umbenannt, einseitig</translation>
    </message>
    <message>
        <source>permutation test of group labels</source>
        <translation>Permutationstest der Gruppenzugehörigkeit</translation>
    </message>
    <message>
        <source>repeated-measures ANOVA</source>
        <translation>Varianzanalyse mit Messwiederholung</translation>
    </message>
    <message>
        <source>repeated-measures ANOVA with Greenhouse–Geisser correction</source>
        <translation>Varianzanalyse mit Messwiederholung und Greenhouse-Geisser-Korrektur</translation>
    </message>
    <message>
        <source>t test of the log ratio of two peaks</source>
        <translation>t-Test des logarithmierten Verhältnisses zweier Maxima</translation>
    </message>
    <message>
        <source>within-participant permutation test</source>
        <translation>Permutationstest innerhalb der Versuchspersonen</translation>
    </message>
    <message>
        <source>sign-flip (randomisation) test</source>
        <translation>Vorzeichen-Permutationstest (Randomisierungstest)</translation>
    </message>
    <message>
        <source>one-sample t test</source>
        <translation>Einstichproben-t-Test</translation>
    </message>
    <message>
        <source>number correct</source>
        <translation>Anzahl richtiger Antworten</translation>
    </message>
    <message>
        <source>difference of the means</source>
        <translation>Differenz der Mittelwerte</translation>
    </message>
    <message>
        <source>Hedges’ g</source>
        <translation>Hedges’ g</translation>
    </message>
    <message>
        <source>Cohen’s h</source>
        <translation>Cohens h</translation>
    </message>
    <message>
        <source>generalised η²</source>
        <translation>generalisiertes η²</translation>
    </message>
    <message>
        <source>Pearson’s X² of the pooled choices</source>
        <translation>Pearsons X² der zusammengefassten Wahlen</translation>
    </message>
    <message>
        <source>Kendall’s W</source>
        <translation>Kendalls W</translation>
    </message>
    <message>
        <source>Mallows’ θ</source>
        <translation>Mallows’ θ</translation>
    </message>
    <message>
        <source>difference in the number of choices</source>
        <translation>Differenz der Wahlhäufigkeiten</translation>
    </message>
    <message>
        <source>Cohen’s d of paired differences</source>
        <translation>Cohens d gepaarter Differenzen</translation>
    </message>
    <message>
        <source>Cohen’s d</source>
        <translation>Cohens d</translation>
    </message>
    <message>
        <source>permutation test of independence</source>
        <translation>Permutationstest auf Unabhängigkeit</translation>
    </message>
    <message>
        <source>The CIs of W for choices are approximate: in simulations with 12 and 20 participants, their coverage was 77 to 100 %.</source>
        <translation>Die Konfidenzintervalle von W bei Wahlen sind Näherungen: In Simulationen mit 12 und 20 Versuchspersonen enthielten sie den wahren Wert in 77 bis 100 % der Studien.</translation>
    </message>
    <message>
        <source>bias-corrected transmitted information in bits</source>
        <translation>bias-korrigierte übertragene Information in Bit</translation>
    </message>
    <message>
        <source>Friedman test</source>
        <translation>Friedman-Test</translation>
    </message>
    <message>
        <source>Kendall’s coefficient of concordance</source>
        <translation>Kendalls Konkordanzkoeffizient</translation>
    </message>
    <message>
        <source>Wilcoxon signed-rank test</source>
        <translation>Wilcoxon-Vorzeichen-Rang-Test</translation>
    </message>
    <message>
        <source>sum of the ranks of positive differences</source>
        <translation>Summe der Ränge positiver Differenzen</translation>
    </message>
    <message>
        <source>rank-biserial correlation</source>
        <translation>rangbiseriale Korrelation</translation>
    </message>
    <message>
        <source>paired t test</source>
        <translation>t-Test für gepaarte Stichproben</translation>
    </message>
    <message>
        <source>permutation test of a regression on the positions</source>
        <translation>Permutationstest einer Regression auf die Positionen</translation>
    </message>
    <message>
        <source>permutation test of the stress</source>
        <translation>Permutationstest des Stress</translation>
    </message>
    <message>
        <source>t test of the exponent against 0, two-sided</source>
        <translation>zweiseitiger t-Test des Exponenten gegen 0</translation>
    </message>
    <message>
        <source>The CIs of d for choices are approximate: in simulations, their coverage was at least 92 % with a true d of at most 0.8, and at least 57 % with a larger one.</source>
        <translation>Die KIs von d für Wahlen sind Näherungen: In Simulationen enthielten sie den wahren Wert in mindestens 92 % der Studien bei einem wahren d von höchstens 0,8 und in mindestens 57 % bei einem größeren.</translation>
    </message>
    <message>
        <source>difference of the mean numbers of correctly matched items per trial</source>
        <translation>Differenz der mittleren Zahlen richtig zugeordneter Items je Durchgang</translation>
    </message>
    <message>
        <source>permutation test of group labels of profiles</source>
        <translation>Permutationstest der Gruppenzugehörigkeit von Profilen</translation>
    </message>
    <message>
        <source>permutation test of group labels of logarithms</source>
        <translation>Permutationstest der Gruppenzugehörigkeit mit Logarithmen</translation>
    </message>
    <message>
        <source>difference of the mean logarithms</source>
        <translation>Differenz der mittleren Logarithmen</translation>
    </message>
</context>
<context>
    <name>TimeAgo</name>
    <message>
        <source>less than an hour ago</source>
        <translation>vor weniger als einer Stunde</translation>
    </message>
    <message>
        <source>an hour ago</source>
        <translation>vor einer Stunde</translation>
    </message>
    <message>
        <source>%1 hours ago</source>
        <translation>vor %1 Stunden</translation>
    </message>
    <message>
        <source>%1 days ago</source>
        <translation>vor %1 Tagen</translation>
    </message>
</context>
<context>
    <name>Troubles</name>
    <message>
        <source>%1 Every completed trial is stored.</source>
        <translation>%1 Jeder abgeschlossene Durchgang ist gespeichert.</translation>
    </message>
    <message>
        <source>%1; the force is zero, and every completed trial is stored</source>
        <translation>%1; die Kraft ist null, und jeder abgeschlossene Durchgang ist gespeichert</translation>
    </message>
    <message>
        <source>The masking noise has stopped, and the session is paused. Fix the problem with the sound, then resume.</source>
        <translation>Das Maskierrauschen ist verstummt, und die Sitzung ist angehalten. Das Problem mit dem Ton beheben, dann fortsetzen.</translation>
    </message>
    <message>
        <source>%1 The force is zero until the fault is cleared.</source>
        <translation>%1 Die Kraft ist null, bis die Störung quittiert ist.</translation>
    </message>
    <message>
        <source>%1 Zero force was requested, but the driver does not respond: if the handle still exerts a force, switch the device off.</source>
        <translation>%1 Kraft null wurde angefordert, aber der Treiber antwortet nicht: Wenn der Griff noch eine Kraft ausübt, das Gerät ausschalten.</translation>
    </message>
    <message>
        <source>%1 The device is not ready yet: %2.</source>
        <translation>%1 Das Gerät ist noch nicht bereit: %2.</translation>
    </message>
    <message>
        <source>%1 The force is zero until the stop is cleared.</source>
        <translation>%1 Die Kraft ist null, bis der Halt quittiert ist.</translation>
    </message>
    <message>
        <source>%1 The emergency stop was pressed in the meantime.</source>
        <translation>%1 Der NOT-HALT wurde inzwischen gedrückt.</translation>
    </message>
    <message>
        <source>The masking noise cannot start: the sound card does not play. The session is paused. Fix the problem with the sound, then resume.</source>
        <translation>Das Maskierrauschen kann nicht starten: Die Soundkarte gibt keinen Ton aus. Die Sitzung ist angehalten. Das Problem mit dem Ton beheben, dann fortsetzen.</translation>
    </message>
    <message>
        <source>The servo loop stalled for more than 50 ms: the force was set to zero, and the interrupted step is repeated. At the third occurrence the session stops.</source>
        <translation>Die Servoschleife stand länger als 50 ms still: Die Kraft wurde auf null gesetzt, und der unterbrochene Schritt wird wiederholt. Beim dritten Mal wird die Sitzung gestoppt.</translation>
    </message>
    <message>
        <source>%1 The session is paused; every completed trial is stored. Fix the problem, then resume: the program is started again and receives the responses so far.</source>
        <translation>%1 Die Sitzung ist angehalten; jeder abgeschlossene Durchgang ist gespeichert. Das Problem beheben, dann fortsetzen: Das Programm wird neu gestartet und erhält die bisherigen Antworten.</translation>
    </message>
</context>
<context>
    <name>UnfinishedSession</name>
    <message>
        <source>the session last ran %1, but the protocol requires sessions to be resumed within %2 h</source>
        <translation>die Sitzung lief zuletzt %1, aber das Protokoll verlangt, dass Sitzungen innerhalb von %2 h fortgesetzt werden</translation>
    </message>
</context>
<context>
    <name>asperity::AbortDialog</name>
    <message>
        <source>Abort the session?</source>
        <translation>Sitzung abbrechen?</translation>
    </message>
    <message>
        <source>Reason for aborting the session</source>
        <translation>Grund für den Abbruch der Sitzung</translation>
    </message>
    <message>
        <source>Abort session</source>
        <translation>Sitzung abbrechen</translation>
    </message>
    <message>
        <source>Nothing is lost: every completed trial is stored. The trial under way is stored as aborted and will be presented again when the session is resumed.</source>
        <translation>Nichts geht verloren: Jeder abgeschlossene Durchgang ist gespeichert. Der laufende Durchgang wird als abgebrochen gespeichert und erneut dargeboten, wenn die Sitzung fortgesetzt wird.</translation>
    </message>
</context>
<context>
    <name>asperity::AboutDialog</name>
    <message>
        <source>About Asperity</source>
        <translation>Über Asperity</translation>
    </message>
    <message>
        <source>Asperity</source>
        <translation>Asperity</translation>
    </message>
    <message>
        <source>Psychophysics experiments on haptic texture.</source>
        <translation>Psychophysische Experimente zu haptischen Texturen.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder neuer, ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>The documents are not installed on this computer.</source>
        <translation>Die Dokumente sind auf diesem Rechner nicht installiert.</translation>
    </message>
    <message>
        <source>The documents are in %1.</source>
        <translation>Die Dokumente liegen in %1.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>asperity::AnalysisPage</name>
    <message>
        <source>human participants</source>
        <translation>menschliche Versuchspersonen</translation>
    </message>
    <message>
        <source>pilot sessions</source>
        <translation>Pilotsitzungen</translation>
    </message>
    <message>
        <source>virtual participants</source>
        <translation>virtuelle Versuchspersonen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>No responses yet</source>
        <translation>Noch keine Antworten</translation>
    </message>
    <message>
        <source>When a session has been run or simulated, its responses are counted and tested here. Start a session on the Protocols page.</source>
        <translation>Sobald eine Sitzung durchgeführt oder simuliert wurde, werden ihre Antworten hier gezählt und statistisch geprüft. Eine Sitzung auf der Seite „Protokolle“ starten.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>There are no sessions to export yet.</source>
        <translation>Es gibt noch keine Sitzungen für einen Export.</translation>
    </message>
    <message>
        <source>New folder for the tables</source>
        <translation>Neuer Ordner für die Tabellen</translation>
    </message>
    <message>
        <source>1 participant</source>
        <translation>1 Versuchsperson</translation>
    </message>
    <message numerus="yes">
        <source>%n participants</source>
        <translation>
            <numerusform>%n Versuchsperson</numerusform>
            <numerusform>%n Versuchspersonen</numerusform>
        </translation>
    </message>
    <message>
        <source>1 response</source>
        <translation>1 Antwort</translation>
    </message>
    <message numerus="yes">
        <source>%n responses</source>
        <translation>
            <numerusform>%n Antwort</numerusform>
            <numerusform>%n Antworten</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2 · %3 · %4 counted</source>
        <translation>%1 %2 · %3 · %4 gezählt</translation>
    </message>
    <message>
        <source>The results of %1 appear here when its responses have been counted. To see those of another protocol, select it.</source>
        <translation>Die Ergebnisse von %1 erscheinen hier, sobald die Antworten gezählt sind. Um die eines anderen Protokolls zu sehen, wählen Sie es aus.</translation>
    </message>
    <message>
        <source>%1 %2
%3 · %4</source>
        <translation>%1 %2
%3 · %4</translation>
    </message>
    <message>
        <source>Blinding during a session</source>
        <translation>Verblindung während einer Sitzung</translation>
    </message>
    <message>
        <source>A session of the protocol %1 is running. The protocol&apos;s results are shown by name once the session has ended.</source>
        <translation>Eine Sitzung des Protokolls %1 läuft. Die Ergebnisse dieses Protokolls werden erst nach ihrem Ende mit Namen gezeigt.</translation>
    </message>
    <message>
        <source>Counting the responses…</source>
        <translation>Antworten werden gezählt…</translation>
    </message>
    <message>
        <source>Counting the responses was cancelled; the previous results are shown. Count again to update them.</source>
        <translation>Das Zählen der Antworten wurde abgebrochen; die bisherigen Ergebnisse werden angezeigt. Zum Aktualisieren erneut zählen.</translation>
    </message>
    <message>
        <source>Count again</source>
        <translation>Noch einmal zählen</translation>
    </message>
    <message>
        <source>The tables are being written.</source>
        <translation>Die Tabellen werden gerade geschrieben.</translation>
    </message>
    <message>
        <source>Writing the tables to %1 …</source>
        <translation>Tabellen werden nach %1 geschrieben…</translation>
    </message>
    <message>
        <source>Writing the tables was cancelled. No part of them remains in %1. To write them, export the tables again.</source>
        <translation>Das Schreiben der Tabellen wurde abgebrochen. In %1 ist nichts davon zurückgeblieben. Um sie zu schreiben, die Tabellen erneut exportieren.</translation>
    </message>
    <message>
        <source>With tick-by-tick recordings (large files)</source>
        <translation>Mit Aufzeichnungen jedes Takts (große Dateien)</translation>
    </message>
    <message>
        <source>For publication: without dates, free text and questionnaires</source>
        <translation>Zur Veröffentlichung: ohne Datumsangaben, Freitext und Fragebögen</translation>
    </message>
    <message>
        <source>New random labels for the participants</source>
        <translation>Neue zufällige Kürzel für die Versuchspersonen</translation>
    </message>
    <message>
        <source>Ages in bands of at least five participants</source>
        <translation>Alter in Gruppen von mindestens fünf Versuchspersonen</translation>
    </message>
    <message>
        <source>Notes on this table</source>
        <translation>Hinweise zu dieser Tabelle</translation>
    </message>
    <message numerus="yes">
        <source>README.txt contains %n further warning(s).</source>
        <translation>
            <numerusform>README.txt enthält %n weitere Warnung.</numerusform>
            <numerusform>README.txt enthält %n weitere Warnungen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files are in %1; codebook.tsv describes every column.</source>
        <translation>
            <numerusform>%n Datei liegt in %1; codebook.tsv beschreibt jede Spalte.</numerusform>
            <numerusform>%n Dateien liegen in %1; codebook.tsv beschreibt jede Spalte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export tables…</source>
        <translation>Tabellen exportieren…</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The responses have not been counted yet</source>
        <translation>Die Antworten sind noch nicht gezählt</translation>
    </message>
    <message>
        <source>The questions, answers and figures of the study appear here when they have been.</source>
        <translation>Fragen, Ergebnisse und Abbildungen der Studie erscheinen hier, sobald sie gezählt sind.</translation>
    </message>
    <message>
        <source>Counting the responses was cancelled. Count again to see the results.</source>
        <translation>Das Zählen der Antworten wurde abgebrochen. Für die Ergebnisse erneut zählen.</translation>
    </message>
    <message>
        <source>There are new results of %1.</source>
        <translation>Es gibt neue Ergebnisse von %1.</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Ergebnisse zeigen</translation>
    </message>
</context>
<context>
    <name>asperity::AnswersPanel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No response yet</source>
        <translation>Noch keine Antwort</translation>
    </message>
    <message>
        <source>Earlier responses, by trial: %1</source>
        <translation>Frühere Antworten, nach Durchgang: %1</translation>
    </message>
    <message>
        <source>%1 s after the cue</source>
        <translation>%1 s nach dem Signal</translation>
    </message>
    <message>
        <source>%1, correct</source>
        <translation>%1, richtig</translation>
    </message>
    <message>
        <source>%1, incorrect</source>
        <translation>%1, falsch</translation>
    </message>
    <message>
        <source>Last:</source>
        <translation>Letzte:</translation>
    </message>
</context>
<context>
    <name>asperity::AssumptionFields</name>
    <message>
        <source>must be 0 or more</source>
        <translation>muss mindestens 0 sein</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>muss über 0 liegen</translation>
    </message>
    <message>
        <source>must be from 0 to 1</source>
        <translation>muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>%1, SD</source>
        <translation>%1, SD</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
</context>
<context>
    <name>asperity::AttemptPage</name>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>← Previous</source>
        <translation>← Voriger</translation>
    </message>
    <message>
        <source>Next →</source>
        <translation>Nächster →</translation>
    </message>
    <message>
        <source>All trials of the session</source>
        <translation>Alle Durchgänge der Sitzung</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Responses and measures</source>
        <translation>Antworten und Messwerte</translation>
    </message>
    <message>
        <source>Events and decisions</source>
        <translation>Ereignisse und Entscheidungen</translation>
    </message>
    <message>
        <source>Flag…</source>
        <translation>Markieren…</translation>
    </message>
    <message>
        <source>Exclude…</source>
        <translation>Ausschließen…</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Events and decisions (%1)</source>
        <translation>Ereignisse und Entscheidungen (%1)</translation>
    </message>
    <message>
        <source>Include again…</source>
        <translation>Wieder einschließen…</translation>
    </message>
    <message>
        <source>The whole session is excluded; it can be included again on its page.</source>
        <translation>Die ganze Sitzung ist ausgeschlossen; auf ihrer Seite kann sie wieder eingeschlossen werden.</translation>
    </message>
    <message>
        <source>There is nothing to exclude: the attempt is not counted.</source>
        <translation>Es gibt nichts auszuschließen: Der Versuch wird nicht gezählt.</translation>
    </message>
    <message>
        <source>This attempt has no recording. Its responses and measures are on the next page.</source>
        <translation>Dieser Versuch hat keine Aufzeichnung. Seine Antworten und Messwerte stehen auf der nächsten Seite.</translation>
    </message>
    <message>
        <source>Reading the recording…</source>
        <translation>Aufzeichnung wird gelesen…</translation>
    </message>
    <message>
        <source>The recording of this attempt is empty: the attempt ended before the first tick.</source>
        <translation>Die Aufzeichnung dieses Versuchs ist leer: Der Versuch endete vor dem ersten Takt.</translation>
    </message>
    <message>
        <source>The recording cannot be shown: %1. The responses and measures of the attempt are stored and not affected.</source>
        <translation>Die Aufzeichnung kann nicht gezeigt werden: %1. Antworten und Messwerte des Versuchs sind gespeichert und davon nicht betroffen.</translation>
    </message>
    <message>
        <source>Flag attempt</source>
        <translation>Versuch markieren</translation>
    </message>
    <message>
        <source>Reason for including the attempt in the analyses again</source>
        <translation>Grund für den Wiedereinschluss des Versuchs in die Auswertungen</translation>
    </message>
    <message>
        <source>Include attempt</source>
        <translation>Versuch einschließen</translation>
    </message>
    <message>
        <source>Reason for excluding the attempt from the analyses. It remains in the study and can be included again.</source>
        <translation>Grund für den Ausschluss des Versuchs von den Auswertungen. Er bleibt in der Studie und kann wieder eingeschlossen werden.</translation>
    </message>
    <message>
        <source>Exclude attempt</source>
        <translation>Versuch ausschließen</translation>
    </message>
    <message>
        <source>File for the table</source>
        <translation>Datei für die Tabelle</translation>
    </message>
    <message>
        <source>Tab-separated table (*.tsv)</source>
        <translation>Tabulatorgetrennte Tabelle (*.tsv)</translation>
    </message>
    <message>
        <source>Reading the recording was cancelled. Open the attempt again to read it.</source>
        <translation>Das Lesen der Aufzeichnung wurde abgebrochen. Um sie zu lesen, den Versuch erneut öffnen.</translation>
    </message>
    <message>
        <source>The session is running, and its experimenter is blind: stimuli and responses are shown here once it has ended.</source>
        <translation>Die Sitzung läuft, und ihre Versuchsleitung ist verblindet: Reize und Antworten werden hier gezeigt, sobald die Sitzung beendet ist.</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 wird geschrieben…</translation>
    </message>
    <message>
        <source>Writing %1 was cancelled. To write the table, export the recording again.</source>
        <translation>Das Schreiben von %1 wurde abgebrochen. Um die Tabelle zu schreiben, die Aufzeichnung erneut exportieren.</translation>
    </message>
    <message>
        <source>Textures and models are shown by name, although the session is not complete: an experimenter who resumes it is no longer blind to them.</source>
        <translation>Texturen und Modelle werden mit Namen gezeigt, obwohl die Sitzung nicht abgeschlossen ist: Eine Versuchsleitung, die sie fortsetzt, ist nicht mehr verblindet.</translation>
    </message>
    <message>
        <source>Reason for flagging the attempt. It remains in the analyses.</source>
        <translation>Grund für die Markierung des Versuchs. Er bleibt in den Auswertungen.</translation>
    </message>
    <message numerus="yes">
        <source>%n tick(s) are in %1; docs/formats/recording.md describes the columns.</source>
        <translation>
            <numerusform>%n Takt steht in %1; docs/formats/recording.md beschreibt die Spalten.</numerusform>
            <numerusform>%n Takte stehen in %1; docs/formats/recording.md beschreibt die Spalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Parts of the attempt</source>
        <translation>Teile des Versuchs</translation>
    </message>
</context>
<context>
    <name>asperity::Banner</name>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
</context>
<context>
    <name>asperity::BatchSimulation</name>
    <message>
        <source>The sessions of virtual participants are being simulated. Cancel the simulation first.</source>
        <translation>Die Sitzungen virtueller Versuchspersonen werden simuliert. Zuerst die Simulation abbrechen.</translation>
    </message>
    <message numerus="yes">
        <source>Simulating %n virtual participants …</source>
        <translation>
            <numerusform>%n virtuelle Versuchsperson wird simuliert …</numerusform>
            <numerusform>%n virtuelle Versuchspersonen werden simuliert …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sessions were simulated.</source>
        <translation>
            <numerusform>%n Sitzung wurde simuliert.</numerusform>
            <numerusform>%n Sitzungen wurden simuliert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Trials of all blocks: %1.</source>
        <translation>Durchgänge aller Blöcke: %1.</translation>
    </message>
    <message>
        <source>Show the sessions</source>
        <translation>Sitzungen zeigen</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Ergebnisse zeigen</translation>
    </message>
    <message>
        <source>The simulation was cancelled.</source>
        <translation>Die Simulation wurde abgebrochen.</translation>
    </message>
    <message>
        <source>No trial was completed.</source>
        <translation>Kein Durchgang wurde abgeschlossen.</translation>
    </message>
    <message>
        <source>Trials completed and stored: %1. Resume the simulation to complete it.</source>
        <translation>Abgeschlossene und gespeicherte Durchgänge: %1. Die Simulation fortsetzen, um sie abzuschließen.</translation>
    </message>
    <message>
        <source>Resume the simulation</source>
        <translation>Simulation fortsetzen</translation>
    </message>
</context>
<context>
    <name>asperity::BoundField</name>
    <message>
        <source>Same in all trials</source>
        <translation>Immer gleich</translation>
    </message>
    <message>
        <source>Level of %1</source>
        <translation>Stufe von %1</translation>
    </message>
    <message>
        <source>%1: same in all trials, or the level of a factor</source>
        <translation>%1: in allen Durchgängen gleich, oder die Stufe eines Faktors</translation>
    </message>
</context>
<context>
    <name>asperity::CheckList</name>
    <message>
        <source>Checklist</source>
        <translation>Checkliste</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Everything is ready.</source>
        <translation>Alles ist bereit.</translation>
    </message>
    <message>
        <source>Comparing every stimulus with the device: %1 %.</source>
        <translation>Jeder Reiz wird mit dem Gerät verglichen: %1 %.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling the checks…</source>
        <translation>Die Prüfungen werden abgebrochen…</translation>
    </message>
    <message>
        <source>Checking stimuli, device and timing (up to a minute)…</source>
        <translation>Reize, Gerät und Zeitverhalten werden geprüft (bis zu einer Minute)…</translation>
    </message>
    <message>
        <source>1 item must be resolved before the session can start.</source>
        <translation>1 Punkt muss geklärt werden, bevor die Sitzung beginnen kann.</translation>
    </message>
    <message numerus="yes">
        <source>%n items must be resolved before the session can start.</source>
        <translation>
            <numerusform>%n Punkt muss geklärt werden, bevor die Sitzung beginnen kann.</numerusform>
            <numerusform>%n Punkte müssen geklärt werden, bevor die Sitzung beginnen kann.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ready (%n warning(s)).</source>
        <translation>
            <numerusform>Bereit (%n Warnung).</numerusform>
            <numerusform>Bereit (%n Warnungen).</numerusform>
        </translation>
    </message>
    <message>
        <source>The checks were cancelled. Press “Check again”: the session can start once they have been completed.</source>
        <translation>Die Prüfungen wurden abgebrochen. „Erneut prüfen“ drücken: Die Sitzung kann beginnen, sobald sie abgeschlossen sind.</translation>
    </message>
</context>
<context>
    <name>asperity::ChoiceField</name>
    <message>
        <source>– not stated –</source>
        <translation>– nicht angegeben –</translation>
    </message>
    <message>
        <source>New factor…</source>
        <translation>Neuer Faktor…</translation>
    </message>
</context>
<context>
    <name>asperity::CloseDialog</name>
    <message>
        <source>Session under way</source>
        <translation>Laufende Sitzung</translation>
    </message>
    <message>
        <source>Abort now</source>
        <translation>Jetzt abbrechen</translation>
    </message>
    <message>
        <source>Stop after this trial</source>
        <translation>Nach diesem Durchgang stoppen</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>No data are lost: every completed trial is stored, and the session can be resumed. The window closes once the session has ended.</source>
        <translation>Es gehen keine Daten verloren: Jeder abgeschlossene Durchgang ist gespeichert, und die Sitzung kann fortgesetzt werden. Das Fenster wird geschlossen, sobald die Sitzung beendet ist.</translation>
    </message>
</context>
<context>
    <name>asperity::ConsentCard</name>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Witnessed by *</source>
        <translation>Bezeugt von *</translation>
    </message>
    <message>
        <source>The participant has agreed to this statement (version %1)</source>
        <translation>Die Versuchsperson hat dieser Erklärung zugestimmt (Version %1)</translation>
    </message>
    <message>
        <source>The participant has not agreed to the statement yet; tick the box when the participant agrees.</source>
        <translation>Die Versuchsperson hat der Erklärung noch nicht zugestimmt; das Kästchen ankreuzen, wenn sie zustimmt.</translation>
    </message>
    <message>
        <source>The witness of the participant&apos;s consent has not been entered; enter the name.</source>
        <translation>Es ist nicht angegeben, wer die Einwilligung bezeugt hat; den Namen eingeben.</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>um %1</translation>
    </message>
</context>
<context>
    <name>asperity::CopyStimuliDialog</name>
    <message>
        <source>Copy stimuli from another study</source>
        <translation>Reize aus einer anderen Studie kopieren</translation>
    </message>
    <message>
        <source>No study chosen yet.</source>
        <translation>Noch keine Studie gewählt.</translation>
    </message>
    <message>
        <source>Choose a study…</source>
        <translation>Studie wählen…</translation>
    </message>
    <message>
        <source>Stimuli of the other study</source>
        <translation>Reize der anderen Studie</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Choose the folder of a study</source>
        <translation>Den Ordner einer Studie wählen</translation>
    </message>
    <message>
        <source>Comparing the files…</source>
        <translation>Die Dateien werden verglichen…</translation>
    </message>
    <message>
        <source>%1 (this study has the same file)</source>
        <translation>%1 (diese Studie hat dieselbe Datei)</translation>
    </message>
    <message>
        <source>%1 (this study has another file of this name)</source>
        <translation>%1 (diese Studie hat eine andere Datei dieses Namens)</translation>
    </message>
    <message>
        <source>Choose a study.</source>
        <translation>Eine Studie wählen.</translation>
    </message>
    <message>
        <source>This study has no stimuli.</source>
        <translation>Diese Studie hat keine Reize.</translation>
    </message>
    <message>
        <source>Tick the stimuli to copy.</source>
        <translation>Die Reize ankreuzen, die kopiert werden sollen.</translation>
    </message>
    <message>
        <source>Files to copy: %1. No file is replaced.</source>
        <translation>Zu kopierende Dateien: %1. Keine Datei wird ersetzt.</translation>
    </message>
</context>
<context>
    <name>asperity::DecisionForm</name>
    <message>
        <source>Choose a reason or enter one</source>
        <translation>Grund wählen oder eingeben</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Decided by</source>
        <translation>Entschieden von</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The decision is stored with the time; the data remain unchanged.</source>
        <translation>Die Entscheidung wird mit dem Zeitpunkt gespeichert; die Daten bleiben unverändert.</translation>
    </message>
    <message>
        <source>The decision could not be stored: %1</source>
        <translation>Die Entscheidung konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>This study is read-only: no decision can be stored. Copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt: Es kann keine Entscheidung gespeichert werden. Die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>Choose or enter a reason, so that the decision can be understood later.</source>
        <translation>Einen Grund wählen oder eingeben, damit die Entscheidung später nachvollziehbar ist.</translation>
    </message>
</context>
<context>
    <name>asperity::DeviceChooser</name>
    <message>
        <source>Simulated device</source>
        <translation>Simuliertes Gerät</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message>
        <source>Mouse or pen (input only)</source>
        <translation>Maus oder Stift (nur Eingabe)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Show devices that cannot be used</source>
        <translation>Nicht benutzbare Geräte zeigen</translation>
    </message>
    <message>
        <source>Try this device</source>
        <translation>Dieses Gerät ausprobieren</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>%1: not usable</source>
        <translation>%1: nicht benutzbar</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Several virtual participants are simulated on the plain simulated device.</source>
        <translation>Mehrere virtuelle Versuchspersonen werden mit dem einfachen simulierten Gerät simuliert.</translation>
    </message>
    <message>
        <source>The device cannot be used at present: resolve the problem stated here, or choose another device.</source>
        <translation>Das Gerät kann derzeit nicht verwendet werden: das hier genannte Problem beheben oder ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>Not tried yet. “Try this device” opens it and runs the servo loop for a third of a second without force.</source>
        <translation>Noch nicht ausprobiert. „Dieses Gerät ausprobieren“ öffnet es und lässt die Servoschleife eine Drittelsekunde lang ohne Kraft laufen.</translation>
    </message>
    <message>
        <source>The device is being tried; wait for the result.</source>
        <translation>Das Gerät wird ausprobiert; das Ergebnis abwarten.</translation>
    </message>
    <message>
        <source>Allow motion</source>
        <translation>Bewegung zulassen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Einrichten…</translation>
    </message>
    <message>
        <source>Location of the firmware, the manufacturer&apos;s library or the service of a device, if it is not found.</source>
        <translation>Ort der Firmware, der Herstellerbibliothek oder des Herstellerdienstes eines Geräts, falls er nicht gefunden wird.</translation>
    </message>
    <message>
        <source>“Set up…”</source>
        <translation>„Einrichten…“</translation>
    </message>
    <message>
        <source>Keep hands away: the device moves by itself until it has found its zero position. To stop it, press Esc or Cancel, or switch it off.</source>
        <translation>Hände fernhalten: Das Gerät bewegt sich von selbst, bis es seine Nullposition gefunden hat. Zum Stoppen Esc oder „Abbrechen“ drücken oder das Gerät ausschalten.</translation>
    </message>
    <message>
        <source>A virtual hand holds it; the participant feels nothing.</source>
        <translation>Eine virtuelle Hand hält es; die Versuchsperson fühlt nichts.</translation>
    </message>
    <message>
        <source>A virtual hand holds it, with the latency, position steps and forces of the device as far as they are known. The participant feels nothing.</source>
        <translation>Eine virtuelle Hand hält es, mit Latenz, Positionsschritten und Kräften des Geräts, soweit sie bekannt sind. Die Versuchsperson fühlt nichts.</translation>
    </message>
    <message>
        <source>In the participant&apos;s window, the mouse moves the probe and presses it while the button is held; a pen presses it with its own pressure. The participant feels no force.</source>
        <translation>Im Fenster der Versuchsperson bewegt die Maus den Taster und drückt ihn an, solange die Maustaste gehalten wird; ein Stift drückt ihn mit dem Druck seiner Spitze an. Die Versuchsperson fühlt keine Kraft.</translation>
    </message>
    <message>
        <source>Rescan</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>The search for devices failed: %1</source>
        <translation>Die Suche nach Geräten ist fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>The device is not connected: plug it in, check its power supply, and press “Rescan”.</source>
        <translation>Das Gerät ist nicht angeschlossen: anschließen, Stromversorgung prüfen und „Erneut suchen“ drücken.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>Searching for devices…</source>
        <translation>Geräte werden gesucht…</translation>
    </message>
    <message>
        <source>Tried: the device responds. Details are in the checklist.</source>
        <translation>Ausprobiert: Das Gerät antwortet. Einzelheiten stehen in der Checkliste.</translation>
    </message>
    <message>
        <source>Opening the device…</source>
        <translation>Das Gerät wird geöffnet…</translation>
    </message>
</context>
<context>
    <name>asperity::DeviceTestPage</name>
    <message>
        <source>Device test</source>
        <translation>Gerätetest</translation>
    </message>
    <message>
        <source>← All devices</source>
        <translation>← Alle Geräte</translation>
    </message>
    <message>
        <source>■ Stop: no force (Esc)</source>
        <translation>■ Halt: keine Kraft (Esc)</translation>
    </message>
    <message>
        <source>No device chosen</source>
        <translation>Kein Gerät gewählt</translation>
    </message>
    <message>
        <source>The Devices page lists the devices that can be tested.</source>
        <translation>Auf der Seite „Geräte“ stehen die Geräte, die getestet werden können.</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>Geräte zeigen</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Limits of</source>
        <translation>Grenzwerte von</translation>
    </message>
    <message>
        <source>Maximum force</source>
        <translation>Maximale Kraft</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Profiles of this device</source>
        <translation>Profile dieses Geräts</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Allow motion</source>
        <translation>Bewegung zulassen</translation>
    </message>
    <message>
        <source>Do not allow motion</source>
        <translation>Bewegung nicht zulassen</translation>
    </message>
    <message>
        <source>Stopped: the force is zero, and nothing was stored. To measure the device, begin the test again.</source>
        <translation>Gestoppt: Die Kraft ist null, und es wurde nichts gespeichert. Um das Gerät zu messen, den Test erneut beginnen.</translation>
    </message>
    <message>
        <source>Nothing was measured: %1</source>
        <translation>Es wurde nichts gemessen: %1</translation>
    </message>
    <message>
        <source>Begin the test</source>
        <translation>Test beginnen</translation>
    </message>
    <message>
        <source>Begin: the handle moves</source>
        <translation>Beginnen: Der Griff bewegt sich</translation>
    </message>
    <message>
        <source>This study is read-only: no profile can be stored. Copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt: Es kann kein Profil gespeichert werden. Die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>Esc, F12 and the red button set the force to zero at once. At the end, move the handle along the borders of its workspace.</source>
        <translation>Esc, F12 und der rote Knopf setzen die Kraft sofort auf null. Am Ende den Griff an den Grenzen seines Arbeitsraums entlangführen.</translation>
    </message>
    <message>
        <source>The study has no profile of this device yet; this test measures one. Before a session, its plan is compared with the latest profile.</source>
        <translation>Die Studie hat noch kein Profil dieses Geräts; dieser Test misst eines. Vor einer Sitzung wird ihr Plan mit dem neuesten Profil verglichen.</translation>
    </message>
    <message>
        <source>Asperity (defaults)</source>
        <translation>Asperity (Vorgaben)</translation>
    </message>
    <message>
        <source>Rate at least 950 Hz, 99th percentile of the lateness at most 1 ms.</source>
        <translation>Taktrate mindestens 950 Hz, 99. Perzentil der Verspätung höchstens 1 ms.</translation>
    </message>
    <message>
        <source>At %1 Hz: %2.</source>
        <translation>Bei %1 Hz: %2.</translation>
    </message>
    <message>
        <source>A device is being measured. Stop the measurement first.</source>
        <translation>Ein Gerät wird gemessen. Zuerst die Messung stoppen.</translation>
    </message>
    <message>
        <source>The device is being opened.</source>
        <translation>Das Gerät wird geöffnet.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird gestoppt…</translation>
    </message>
    <message>
        <source>Esc, F12, Pause and Ctrl+Space do the same.</source>
        <translation>Esc, F12, Pause und Strg+Leertaste tun dasselbe.</translation>
    </message>
    <message>
        <source>The device has no motors: it does not move by itself and exerts no force. The timing of the servo loop is measured; then the probe has to be moved by hand along the borders of its workspace.</source>
        <translation>Das Gerät hat keine Motoren: Es bewegt sich nicht von selbst und übt keine Kraft aus. Das Zeitverhalten der Servoschleife wird gemessen; danach den Taster von Hand an den Grenzen seines Arbeitsraums entlangführen.</translation>
    </message>
    <message>
        <source>Not listed: %1</source>
        <translation>Nicht aufgeführt: %1</translation>
    </message>
    <message>
        <source>Keep hands away: the device moves by itself until it has found its zero position. To stop it, press Stop or switch it off.</source>
        <translation>Hände fernhalten: Das Gerät bewegt sich von selbst, bis es seine Nullposition gefunden hat. Zum Stoppen „Halt“ drücken oder das Gerät ausschalten.</translation>
    </message>
    <message>
        <source>Stopped, and nothing was stored: %1</source>
        <translation>Gestoppt; es wurde nichts gespeichert: %1</translation>
    </message>
    <message>
        <source>The profile has been stored as %1.</source>
        <translation>Das Profil wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Rate at least 950 Hz, 99th percentile of the lateness at most 1 ms. Protocols with “limits” in their “device” are listed here; the study has none.</source>
        <translation>Taktrate mindestens 950 Hz, 99. Perzentil der Verspätung höchstens 1 ms. Protokolle mit „limits“ in ihrem „device“ werden hier aufgeführt; die Studie hat keine.</translation>
    </message>
    <message>
        <source>Nothing moves: a virtual hand holds the device, and its mechanics are measured faster than real time. Its timing is that of this computer.</source>
        <translation>Nichts bewegt sich: Eine virtuelle Hand hält das Gerät, und seine Mechanik wird schneller als in Echtzeit gemessen. Das Zeitverhalten ist das dieses Rechners.</translation>
    </message>
</context>
<context>
    <name>asperity::DeviceTestSteps</name>
    <message>
        <source>Do not touch the handle: it hangs free, and no force acts on it. The timing of the servo loop is measured, and the force has to be exactly zero.</source>
        <translation>Den Griff nicht berühren: Er hängt frei, und keine Kraft wirkt auf ihn. Das Zeitverhalten der Servoschleife wird gemessen, und die Kraft muss genau null sein.</translation>
    </message>
    <message>
        <source>Keep hands away: the handle is pulled to and fro along %1, slowly and then faster. Friction and damping are determined from the resistance.</source>
        <translation>Hände fernhalten: Der Griff wird entlang %1 hin- und hergezogen, langsam und dann schneller. Reibung und Dämpfung werden aus dem Widerstand bestimmt.</translation>
    </message>
    <message>
        <source>Keep hands away: sudden force steps act along %1, to and fro. The latency is determined from the delay until the motion begins, the mass from the acceleration.</source>
        <translation>Hände fernhalten: Kraftsprünge wirken entlang %1, hin und her. Die Latenz wird aus der Zeit bis zum Beginn der Bewegung bestimmt, die Masse aus der Beschleunigung.</translation>
    </message>
    <message>
        <source>Keep hands away: the handle is driven along %1 at frequencies from 8 to 200 Hz. Its resonance is determined from its motion.</source>
        <translation>Hände fernhalten: Der Griff wird entlang %1 mit Frequenzen von 8 bis 200 Hz angetrieben. Seine Resonanz wird aus seiner Bewegung bestimmt.</translation>
    </message>
    <message>
        <source>Keep hands away: increasingly stiff springs are rendered along %1, each with a small impulse. The result is the stiffest spring on which the handle comes to rest.</source>
        <translation>Hände fernhalten: Immer steifere Federn werden entlang %1 wiedergegeben, jede mit einem kleinen Impuls. Das Ergebnis ist die steifste Feder, auf der der Griff zur Ruhe kommt.</translation>
    </message>
    <message>
        <source>Keep hands away: increasingly strong small pushes act along %1 until the handle moves.</source>
        <translation>Hände fernhalten: Immer stärkere kleine Stöße wirken entlang %1, bis sich der Griff bewegt.</translation>
    </message>
    <message>
        <source>Now take the handle and move it along all borders of its workspace: left and right, forwards and backwards, up and down. This step lasts %1 seconds; no force is exerted.</source>
        <translation>Jetzt den Griff nehmen und an allen Grenzen seines Arbeitsraums entlangführen: nach links und rechts, nach vorn und hinten, nach oben und unten. Dieser Schritt dauert %1 Sekunden; es wirkt keine Kraft.</translation>
    </message>
    <message>
        <source>Zero force and timing</source>
        <translation>Kraft null und Zeitverhalten</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Slow sweeps</source>
        <translation>Langsame Bewegungen</translation>
    </message>
    <message>
        <source>Force steps</source>
        <translation>Kraftsprünge</translation>
    </message>
    <message>
        <source>Frequency sweep</source>
        <translation>Frequenzdurchlauf</translation>
    </message>
    <message>
        <source>Stiff springs</source>
        <translation>Steife Federn</translation>
    </message>
    <message>
        <source>Weakest force</source>
        <translation>Schwächste Kraft</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>Keep hands away: the handle is pushed softly. A stop, a force that is not finite and an unresponsive program are then tested; each has to end in zero force.</source>
        <translation>Hände fernhalten: Der Griff wird leicht angestoßen. Danach werden ein Halt, eine Kraft, die keine endliche Zahl ist, und ein Programm, das nicht reagiert, getestet; jeder dieser Fälle muss mit der Kraft null enden.</translation>
    </message>
</context>
<context>
    <name>asperity::DevicesPage</name>
    <message>
        <source>Motion sensed</source>
        <translation>Erfasste Bewegung</translation>
    </message>
    <message>
        <source>%1 degrees of freedom</source>
        <translation>%1 Freiheitsgrade</translation>
    </message>
    <message>
        <source>Force output</source>
        <translation>Ausgegebene Kraft</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Position resolution</source>
        <translation>Positionsauflösung</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>exact (simulated)</source>
        <translation>exakt (simuliert)</translation>
    </message>
    <message>
        <source>Highest servo rate</source>
        <translation>Höchste Taktrate</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>this program</source>
        <translation>dieses Programm</translation>
    </message>
    <message>
        <source>the manufacturer&apos;s driver</source>
        <translation>der Treiber des Herstellers</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>The simulated device is always available: a virtual hand holds its probe. The requirements of a protocol are compared with the device before a session starts.</source>
        <translation>Das simulierte Gerät ist immer verfügbar: Eine virtuelle Hand hält seinen Taster. Die Anforderungen eines Protokolls werden vor dem Start einer Sitzung mit dem Gerät verglichen.</translation>
    </message>
    <message>
        <source>%1 ready</source>
        <translation>%1 bereit</translation>
    </message>
    <message>
        <source>not usable yet</source>
        <translation>noch nicht benutzbar</translation>
    </message>
    <message>
        <source>not set up</source>
        <translation>nicht eingerichtet</translation>
    </message>
    <message>
        <source>none attached</source>
        <translation>keines angeschlossen</translation>
    </message>
    <message>
        <source>%1, serial number %2, at %3</source>
        <translation>%1, Seriennummer %2, an %3</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <translation>%1, Seriennummer %2</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, an %2</translation>
    </message>
    <message>
        <source>The search for devices failed: %1</source>
        <translation>Die Suche nach Geräten ist fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Simulated device</source>
        <translation>Simuliertes Gerät</translation>
    </message>
    <message>
        <source>Test this device…</source>
        <translation>Dieses Gerät testen…</translation>
    </message>
    <message>
        <source>Simulated models of devices</source>
        <translation>Simulierte Modelle von Geräten</translation>
    </message>
    <message>
        <source>The simulated device with the workspace, forces, latency and position steps of a real one, as far as they are known: for rehearsing a protocol before the device is available.</source>
        <translation>Das simulierte Gerät mit Arbeitsraum, Kräften, Latenz und Positionsschritten eines echten, soweit sie bekannt sind: um ein Protokoll zu proben, bevor das Gerät verfügbar ist.</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message>
        <source>“Set up…”</source>
        <translation>„Einrichten…“</translation>
    </message>
    <message>
        <source>It replays a recording and is available only at a terminal: asperity run PROTOCOL --device replay:FILE.</source>
        <translation>Es spielt eine Aufzeichnung ab und ist nur im Terminal verfügbar: asperity run PROTOCOL --device replay:FILE.</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Einrichten…</translation>
    </message>
    <message>
        <source>Set up %1</source>
        <translation>%1 einrichten</translation>
    </message>
    <message>
        <source>Rescan</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>Continuous force</source>
        <translation>Dauerkraft</translation>
    </message>
    <message>
        <source>Timing source</source>
        <translation>Taktquelle</translation>
    </message>
</context>
<context>
    <name>asperity::DialogButtons</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>asperity::DocumentDialog</name>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Text of the document</source>
        <translation>Text des Dokuments</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← Zurück</translation>
    </message>
    <message>
        <source>All documents</source>
        <translation>Alle Dokumente</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The documents are not installed on this computer. They are in the folder “docs” of the source, and in the Debian package.</source>
        <translation>Die Dokumente sind auf diesem Rechner nicht installiert. Sie liegen im Ordner „docs“ des Quelltexts und im Debian-Paket.</translation>
    </message>
</context>
<context>
    <name>asperity::DriverSetup</name>
    <message>
        <source>%1: firmware</source>
        <translation>%1: Firmware</translation>
    </message>
    <message>
        <source>%1: library</source>
        <translation>%1: Bibliothek</translation>
    </message>
    <message>
        <source>%1: service</source>
        <translation>%1: Dienst</translation>
    </message>
    <message>
        <source>The file that came with the device&apos;s software. A Falcon loses its firmware when it is switched off; the firmware is loaded when the device is opened.</source>
        <translation>Die mit der Software des Geräts gelieferte Datei. Ein Falcon verliert seine Firmware beim Ausschalten; sie wird geladen, wenn das Gerät geöffnet wird.</translation>
    </message>
    <message>
        <source>The file libHD.so of OpenHaptics, if the system does not find it.</source>
        <translation>Die Datei libHD.so von OpenHaptics, falls das System sie nicht findet.</translation>
    </message>
    <message>
        <source>The file libdrd.so or libdhd.so of the manufacturer&apos;s SDK, if the system does not find it.</source>
        <translation>Die Datei libdrd.so oder libdhd.so aus dem SDK des Herstellers, falls das System sie nicht findet.</translation>
    </message>
    <message>
        <source>Address of Haply&apos;s Inverse Service, HOST:PORT, if it is not 127.0.0.1:10001.</source>
        <translation>Adresse des Inverse Service von Haply, HOST:PORT, falls nicht 127.0.0.1:10001.</translation>
    </message>
    <message>
        <source>no file: only a Falcon whose firmware is already loaded can be used</source>
        <translation>keine Datei: nur ein Falcon mit bereits geladener Firmware ist benutzbar</translation>
    </message>
    <message>
        <source>the system&apos;s search path for libraries</source>
        <translation>Suchpfad des Systems für Bibliotheken</translation>
    </message>
    <message>
        <source>Falcon firmware file</source>
        <translation>Firmware-Datei eines Falcon</translation>
    </message>
    <message>
        <source>Library of %1</source>
        <translation>Bibliothek von %1</translation>
    </message>
    <message>
        <source>the field above</source>
        <translation>dem Feld darüber</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>Gefunden: %1.</translation>
    </message>
    <message>
        <source>%1: ready.</source>
        <translation>%1: bereit.</translation>
    </message>
    <message>
        <source>No device is attached: connect one, and check that it has power.</source>
        <translation>Kein Gerät ist angeschlossen: eines anschließen und prüfen, ob es mit Strom versorgt ist.</translation>
    </message>
    <message>
        <source>Set up %1</source>
        <translation>%1 einrichten</translation>
    </message>
    <message>
        <source>Set up devices</source>
        <translation>Geräte einrichten</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
    <message>
        <source>Opens a dialog for choosing a file on this computer.</source>
        <translation>Öffnet einen Dialog zur Auswahl einer Datei auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation>Leeren: %1</translation>
    </message>
    <message>
        <source>Clears this entry.</source>
        <translation>Leert diesen Eintrag.</translation>
    </message>
    <message>
        <source>Libraries (*.so *.so.*)</source>
        <translation>Bibliotheken (*.so *.so.*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The search for devices failed: %1</source>
        <translation>Die Suche nach Geräten ist fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Enter the full path of the file, beginning with “/” or “~”.</source>
        <translation>Den vollständigen Pfad der Datei eingeben; er beginnt mit „/“ oder „~“.</translation>
    </message>
    <message>
        <source>These settings are stored for all studies. Commands at a terminal do not use them; they have options instead.</source>
        <translation>Diese Einstellungen werden für alle Studien gespeichert. Befehle im Terminal verwenden sie nicht, sondern haben dafür Optionen.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
</context>
<context>
    <name>asperity::EditorSides</name>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Plan, screen, precision</source>
        <translation>Plan, Bildschirm, Präzision</translation>
    </message>
</context>
<context>
    <name>asperity::EndSummary</name>
    <message>
        <source>Show the table</source>
        <translation>Tabelle zeigen</translation>
    </message>
    <message>
        <source>Show the trials</source>
        <translation>Durchgänge zeigen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>✕ The session did not begin</source>
        <translation>✕ Die Sitzung hat nicht begonnen</translation>
    </message>
    <message>
        <source>✓ The session is complete</source>
        <translation>✓ Die Sitzung ist vollständig</translation>
    </message>
    <message>
        <source>▲ The session was stopped</source>
        <translation>▲ Die Sitzung wurde gestoppt</translation>
    </message>
    <message>
        <source>No trial was begun.</source>
        <translation>Kein Durchgang wurde begonnen.</translation>
    </message>
    <message>
        <source>Nothing was stored.</source>
        <translation>Es wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>%1

%2</source>
        <translation>%1

%2</translation>
    </message>
    <message>
        <source>Everything is stored in %1, session %2 of %3.</source>
        <translation>Alles ist in %1 gespeichert, Sitzung %2 von %3.</translation>
    </message>
    <message>
        <source>%1

Resume the session now, or later on the Sessions page.</source>
        <translation>%1

Die Sitzung jetzt fortsetzen oder später auf der Seite „Sitzungen“.</translation>
    </message>
    <message>
        <source>Every completed trial is stored in %1, session %2 of %3.</source>
        <translation>Jeder abgeschlossene Durchgang ist in %1 gespeichert, Sitzung %2 von %3.</translation>
    </message>
    <message>
        <source>Practice trials made again: %1.</source>
        <translation>Wiederholte Übungsdurchgänge: %1.</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>further reasons: %1</source>
        <translation>weitere Gründe: %1</translation>
    </message>
    <message>
        <source>Trials completed: %1 of %2.</source>
        <translation>Abgeschlossene Durchgänge: %1 von %2.</translation>
    </message>
    <message>
        <source>Trials not needed, because the criterion of their block was reached or could no longer be: %1.</source>
        <translation>Nicht benötigte Durchgänge, weil das Kriterium ihres Blocks erreicht oder nicht mehr erreichbar war: %1.</translation>
    </message>
    <message>
        <source>Attempts: %1 (%2 flagged, %3 invalid, %4 skipped).</source>
        <translation>Versuche: %1 (%2 markiert, %3 ungültig, %4 übersprungen).</translation>
    </message>
</context>
<context>
    <name>asperity::EntryList</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Fold “%1”</source>
        <translation>„%1“ zuklappen</translation>
    </message>
    <message>
        <source>Unfold “%1”</source>
        <translation>„%1“ aufklappen</translation>
    </message>
    <message>
        <source>Ticked entries are moved, duplicated and removed together.</source>
        <translation>Angekreuzte Einträge werden gemeinsam verschoben, dupliziert und entfernt.</translation>
    </message>
    <message>
        <source>Choose “%1”</source>
        <translation>„%1“ auswählen</translation>
    </message>
    <message>
        <source>Move “%1” up</source>
        <translation>„%1“ nach oben</translation>
    </message>
    <message>
        <source>Move “%1” down</source>
        <translation>„%1“ nach unten</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>„%1“ duplizieren</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>„%1“ entfernen</translation>
    </message>
    <message>
        <source>+ Add</source>
        <translation>+ Hinzufügen</translation>
    </message>
    <message>
        <source>All names occur already</source>
        <translation>Alle Namen kommen schon vor</translation>
    </message>
</context>
<context>
    <name>asperity::FaultPanel</name>
    <message>
        <source>It is safe: no hand is trapped, nothing touches the device</source>
        <translation>Es ist sicher: Keine Hand ist eingeklemmt, nichts berührt das Gerät</translation>
    </message>
    <message>
        <source>End the session…</source>
        <translation>Sitzung beenden…</translation>
    </message>
    <message>
        <source>Clear and resume</source>
        <translation>Quittieren und fortsetzen</translation>
    </message>
    <message>
        <source>Confirm that it is safe before resuming.</source>
        <translation>Vor dem Fortsetzen bestätigen, dass keine Gefahr besteht.</translation>
    </message>
</context>
<context>
    <name>asperity::FigureSaver</name>
    <message>
        <source>File for the figure</source>
        <translation>Datei für die Abbildung</translation>
    </message>
    <message>
        <source>SVG, for the web and for drawing programs (*.svg)</source>
        <translation>SVG, für das Web und für Zeichenprogramme (*.svg)</translation>
    </message>
    <message>
        <source>PDF, for print and LaTeX (*.pdf)</source>
        <translation>PDF, für Druck und LaTeX (*.pdf)</translation>
    </message>
    <message>
        <source>PNG, for slides and office programs (*.png)</source>
        <translation>PNG, für Folien und Büroprogramme (*.png)</translation>
    </message>
    <message>
        <source>Another figure is being saved; save this one afterwards.</source>
        <translation>Eine andere Abbildung wird gerade gespeichert; diese erst danach speichern.</translation>
    </message>
    <message>
        <source>The file %1 already exists. Replace it, or save the figure under another name.</source>
        <translation>Die Datei %1 existiert bereits. Sie ersetzen oder die Abbildung unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>Replace “%1”</source>
        <translation>„%1“ ersetzen</translation>
    </message>
    <message>
        <source>The figure is in %1.</source>
        <translation>Die Abbildung liegt in %1.</translation>
    </message>
    <message>
        <source>The figure was not saved: %1</source>
        <translation>Die Abbildung wurde nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>The figure is on the clipboard, as a picture and as SVG.</source>
        <translation>Die Abbildung liegt in der Zwischenablage, als Bild und als SVG.</translation>
    </message>
    <message>
        <source>The figure was not copied: %1</source>
        <translation>Die Abbildung wurde nicht kopiert: %1</translation>
    </message>
</context>
<context>
    <name>asperity::FigureView</name>
    <message>
        <source>Save figure</source>
        <translation>Abbildung speichern</translation>
    </message>
    <message>
        <source>Save at the width of a journal column, 85 mm…</source>
        <translation>In der Breite einer Zeitschriftenspalte speichern, 85 mm…</translation>
    </message>
    <message>
        <source>Save at the width of a page, 170 mm…</source>
        <translation>In der Breite einer Seite speichern, 170 mm…</translation>
    </message>
    <message>
        <source>Copy figure</source>
        <translation>Abbildung kopieren</translation>
    </message>
</context>
<context>
    <name>asperity::FindBar</name>
    <message>
        <source>Find in the form</source>
        <translation>Im Formular suchen</translation>
    </message>
    <message>
        <source>Find in the text</source>
        <translation>Im Text suchen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Voriges</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächstes</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>no match</source>
        <translation>kein Treffer</translation>
    </message>
    <message>
        <source>1 match</source>
        <translation>1 Treffer</translation>
    </message>
    <message>
        <source>%1 matches</source>
        <translation>%1 Treffer</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>asperity::ForceComparison</name>
    <message>
        <source>Choose models, then drag the mouse over the relief: the force of each model along the same path of the hand is shown.</source>
        <translation>Modelle wählen, dann mit der Maus über das Relief ziehen: Für jedes Modell wird die Kraft auf demselben Weg der Hand gezeigt.</translation>
    </message>
    <message>
        <source>Stroke once across</source>
        <translation>Einmal darüberstreichen</translation>
    </message>
    <message>
        <source>From left to right at 60 mm/s, always the same</source>
        <translation>Von links nach rechts mit 60 mm/s, immer gleich</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>Force against the motion</source>
        <translation>Kraft gegen die Bewegung</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Hear</source>
        <translation>Hören</translation>
    </message>
    <message>
        <source>There is no sound output. Connect headphones to hear a force.</source>
        <translation>Es gibt keine Tonausgabe. Kopfhörer anschließen, um eine Kraft zu hören.</translation>
    </message>
    <message>
        <source>%1 could not be opened; close other programs that may be using it.</source>
        <translation>%1 ließ sich nicht öffnen; andere Programme schließen, die das Gerät möglicherweise verwenden.</translation>
    </message>
    <message>
        <source>%1 produces no sound. Connect it again, or choose another sound output in the settings of the computer.</source>
        <translation>%1 gibt keinen Ton aus. Neu anschließen oder in den Einstellungen des Rechners eine andere Tonausgabe wählen.</translation>
    </message>
    <message>
        <source>%1: RMS %2 m/s², maximum %3 m/s², %4 dB above the vibrotactile threshold</source>
        <translation>%1: Effektivwert %2 m/s², Maximum %3 m/s², %4 dB über der vibrotaktilen Schwelle</translation>
    </message>
    <message>
        <source>%1: RMS %2 m/s², maximum %3 m/s²</source>
        <translation>%1: Effektivwert %2 m/s², Maximum %3 m/s²</translation>
    </message>
    <message>
        <source>This model touches the relief as a plate. Choose the plane as the body under Surface and hand.</source>
        <translation>Dieses Modell berührt das Relief als Platte. Wählen Sie unter „Oberfläche und Hand“ die Ebene als Körper.</translation>
    </message>
</context>
<context>
    <name>asperity::GroupChooser</name>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Group *</source>
        <translation>Gruppe *</translation>
    </message>
</context>
<context>
    <name>asperity::HealthLine</name>
    <message>
        <source>study.sqlite · attempts stored: %1</source>
        <translation>study.sqlite · gespeicherte Versuche: %1</translation>
    </message>
    <message>
        <source>The servo loop has not run yet</source>
        <translation>Die Servoschleife ist noch nicht gelaufen</translation>
    </message>
    <message>
        <source>masking noise on</source>
        <translation>Maskierrauschen an</translation>
    </message>
    <message>
        <source>masking noise off</source>
        <translation>Maskierrauschen aus</translation>
    </message>
    <message>
        <source>%1 · %2 Hz · p99 %3 µs late · %4 missed · %5 lost · %6 saturated</source>
        <translation>%1 · %2 Hz · p99 %3 µs verspätet · %4 verpasst · %5 verloren · %6 gesättigt</translation>
    </message>
    <message>
        <source>the sound card produces no sound: no masking noise</source>
        <translation>die Soundkarte gibt keinen Ton aus: kein Maskierrauschen</translation>
    </message>
    <message>
        <source>no sound output: no masking noise</source>
        <translation>keine Tonausgabe: kein Maskierrauschen</translation>
    </message>
    <message>
        <source>masking noise from another source (measured)</source>
        <translation>Maskierrauschen aus einer anderen Quelle (gemessen)</translation>
    </message>
    <message>
        <source>the probe is inside the surface: no force until it has left the surface</source>
        <translation>die Sonde ist in der Oberfläche: keine Kraft, bis sie die Oberfläche verlassen hat</translation>
    </message>
</context>
<context>
    <name>asperity::HistoryTables</name>
    <message>
        <source>Decisions about the attempt or its session</source>
        <translation>Entscheidungen über den Versuch oder seine Sitzung</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Betrifft</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Decided by</source>
        <translation>Entschieden von</translation>
    </message>
    <message>
        <source>Events during the attempt</source>
        <translation>Ereignisse während des Versuchs</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>this attempt</source>
        <translation>dieser Versuch</translation>
    </message>
    <message>
        <source>the session</source>
        <translation>die Sitzung</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Wortlaut</translation>
    </message>
</context>
<context>
    <name>asperity::InterruptedNews</name>
    <message>
        <source>Show the sessions</source>
        <translation>Sitzungen zeigen</translation>
    </message>
    <message>
        <source>Session %1 of %2 was interrupted; trials completed and stored: %3 of %4.</source>
        <translation>Sitzung %1 von %2 wurde unterbrochen; Durchgänge abgeschlossen und gespeichert: %3 von %4.</translation>
    </message>
    <message>
        <source>Session %1 of %2 in the study “%5” was interrupted; trials completed and stored: %3 of %4.</source>
        <translation>Sitzung %1 von %2 in der Studie „%5“ wurde unterbrochen; Durchgänge abgeschlossen und gespeichert: %3 von %4.</translation>
    </message>
    <message>
        <source>Other sessions were interrupted as well; they are listed on the Sessions page.</source>
        <translation>Weitere Sitzungen wurden unterbrochen; sie stehen auf der Seite „Sitzungen“.</translation>
    </message>
    <message>
        <source>Resume session %1 of %2</source>
        <translation>Sitzung %1 von %2 fortsetzen</translation>
    </message>
    <message>
        <source>None of the study&apos;s protocols has the text that the session began with: restore %1 version %2 to resume.</source>
        <translation>Kein Protokoll der Studie hat noch den Text, mit dem die Sitzung begann: %1 Version %2 wiederherstellen, um die Sitzung fortzusetzen.</translation>
    </message>
</context>
<context>
    <name>asperity::LivePlots</name>
    <message>
        <source>FORCE N</source>
        <translation>KRAFT N</translation>
    </message>
    <message>
        <source>SPEED mm/s</source>
        <translation>GESCHWINDIGKEIT mm/s</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>no band</source>
        <translation>kein Soll</translation>
    </message>
    <message>
        <source>band %1</source>
        <translation>Soll %1</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>kein Kontakt</translation>
    </message>
    <message>
        <source>no requirement</source>
        <translation>keine Vorgabe</translation>
    </message>
    <message>
        <source>in band %1 %</source>
        <translation>%1 % im Sollbereich</translation>
    </message>
    <message>
        <source>no stroke yet</source>
        <translation>noch kein Strich</translation>
    </message>
    <message>
        <source>strokes: %1, mean %2 mm</source>
        <translation>Striche: %1, Mittel %2 mm</translation>
    </message>
    <message>
        <source>PATH mm</source>
        <translation>WEG mm</translation>
    </message>
</context>
<context>
    <name>asperity::MeasureTables</name>
    <message>
        <source>normal force, N</source>
        <translation>Normalkraft, N</translation>
    </message>
    <message>
        <source>speed, mm/s</source>
        <translation>Geschwindigkeit, mm/s</translation>
    </message>
    <message>
        <source>contact, s</source>
        <translation>Kontakt, s</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>stroke length, mm</source>
        <translation>Strichlänge, mm</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1 or less</source>
        <translation>%1 oder weniger</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>not assessed</source>
        <translation>nicht bewertet</translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>ticks, at %1 Hz</source>
        <translation>Takte, bei %1 Hz</translation>
    </message>
    <message>
        <source>period: mean</source>
        <translation>Periode: Mittelwert</translation>
    </message>
    <message>
        <source>period: 99th percentile</source>
        <translation>Periode: 99. Perzentil</translation>
    </message>
    <message>
        <source>period: maximum</source>
        <translation>Periode: Maximum</translation>
    </message>
    <message>
        <source>lateness: 99th percentile</source>
        <translation>Verspätung: 99. Perzentil</translation>
    </message>
    <message>
        <source>lateness: maximum</source>
        <translation>Verspätung: Maximum</translation>
    </message>
    <message>
        <source>missed deadlines</source>
        <translation>verpasste Fristen</translation>
    </message>
    <message>
        <source>ticks missing from the recording</source>
        <translation>in der Aufzeichnung fehlende Takte</translation>
    </message>
    <message>
        <source>ticks with the force at its limit</source>
        <translation>Takte mit der Kraft an ihrer Grenze</translation>
    </message>
    <message>
        <source>ticks with the growth of the force limited</source>
        <translation>Takte mit begrenztem Anstieg der Kraft</translation>
    </message>
    <message>
        <source>ticks without a finite force</source>
        <translation>Takte ohne endliche Kraft</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Given by</source>
        <translation>Gegeben von</translation>
    </message>
    <message>
        <source>Surfaces felt</source>
        <translation>Gefühlte Oberflächen</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Contact, s</source>
        <translation>Kontakt, s</translation>
    </message>
    <message>
        <source>Texture force, N</source>
        <translation>Texturkraft, N</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Requested</source>
        <translation>Vorgegeben</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>In band</source>
        <translation>Im Sollbereich</translation>
    </message>
    <message>
        <source>Met</source>
        <translation>Erfüllt</translation>
    </message>
    <message>
        <source>Timing of the servo loop</source>
        <translation>Zeitverhalten der Servoschleife</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Assessment</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>check</source>
        <translation>prüfen</translation>
    </message>
    <message>
        <source>Surfaces felt, by name (the session has ended)</source>
        <translation>Gefühlte Oberflächen, mit Namen (die Sitzung ist beendet)</translation>
    </message>
    <message>
        <source>Surfaces felt, by name</source>
        <translation>Gefühlte Oberflächen, mit Namen</translation>
    </message>
    <message>
        <source>a surface was touched</source>
        <translation>eine Oberfläche wurde berührt</translation>
    </message>
    <message>
        <source>viewed along the contact normal, a surface folded over itself; part of it was omitted</source>
        <translation>entlang der Kontaktnormalen überlappte sich eine Oberfläche; ein Teil wurde weggelassen</translation>
    </message>
    <message>
        <source>the deepest point lay at the border of the region searched</source>
        <translation>die tiefste Stelle lag am Rand des durchsuchten Ausschnitts</translation>
    </message>
    <message>
        <source>the shortest wavelength of the texture was shorter than eight samples</source>
        <translation>die kürzeste Wellenlänge der Textur war kürzer als acht Abtastwerte</translation>
    </message>
    <message>
        <source>the tool moved by more than half of the shortest wavelength in one tick</source>
        <translation>das Werkzeug bewegte sich in einem Takt um mehr als die halbe kürzeste Wellenlänge</translation>
    </message>
    <message>
        <source>a contact was too wide for the requested step</source>
        <translation>ein Kontakt war zu breit für den verlangten Schritt</translation>
    </message>
    <message>
        <source>there were more contacts than the model supports; some were omitted</source>
        <translation>es gab mehr Kontakte, als das Modell zulässt; einige wurden weggelassen</translation>
    </message>
    <message>
        <source>a contact persisted although nothing intersected</source>
        <translation>ein Kontakt bestand weiter, obwohl sich nichts schnitt</translation>
    </message>
    <message>
        <source>Counts of the force model, in ticks</source>
        <translation>Vom Kraftmodell gezählte Takte</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>a contact was deeper than the bodies are thick, or steeper than 60°, and was limited</source>
        <translation>ein Kontakt war tiefer, als die Körper dick sind, oder steiler als 60°, und wurde begrenzt</translation>
    </message>
    <message>
        <source>gaps between ticks in contact</source>
        <translation>Lücken zwischen Takten im Kontakt</translation>
    </message>
    <message>
        <source>readings replaced as implausible</source>
        <translation>als unplausibel ersetzte Messwerte</translation>
    </message>
    <message>
        <source>missed deadlines in contact</source>
        <translation>verpasste Fristen im Kontakt</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Antwortmöglichkeiten</translation>
    </message>
    <message>
        <source>The options, in the order in which they were shown.</source>
        <translation>Die Antwortmöglichkeiten in der Reihenfolge, in der sie gezeigt wurden.</translation>
    </message>
    <message>
        <source>the tool lay completely inside the surface, where no force is rendered</source>
        <translation>das Werkzeug lag vollständig in der Oberfläche, wo keine Kraft wiedergegeben wird</translation>
    </message>
    <message>
        <source>Exploration: instructed and observed</source>
        <translation>Exploration: vorgegeben und beobachtet</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Perceived instability</source>
        <translation>Wahrgenommene Instabilität</translation>
    </message>
    <message>
        <source>Force at rest, N</source>
        <translation>Kraft in Ruhe, N</translation>
    </message>
    <message>
        <source>At crests</source>
        <translation>Auf Kämmen</translation>
    </message>
    <message>
        <source>Greatest vibration above 150 Hz that the force model does not explain, relative to the texture force. Values above 0.4 are rare in stable strokes.</source>
        <translation>Stärkste Vibration über 150 Hz, die das Kraftmodell nicht erklärt, im Verhältnis zur Texturkraft. Werte über 0,4 sind bei stabilen Strichen selten.</translation>
    </message>
    <message>
        <source>RMS of the force on the resting hand in 2 to 20 Hz.</source>
        <translation>Effektivwert der Kraft auf die ruhende Hand zwischen 2 und 20 Hz.</translation>
    </message>
    <message>
        <source>Proportion of slow contact near the crests of a grating; 30 % for an even motion.</source>
        <translation>Anteil des langsamen Kontakts nahe den Kämmen eines Gitters; 30 % bei gleichmäßiger Bewegung.</translation>
    </message>
    <message>
        <source>the plug-in reported an error</source>
        <translation>das Plug-in meldete einen Fehler</translation>
    </message>
    <message>
        <source>the plug-in returned a number that is not finite, or a negative force or depth</source>
        <translation>das Plug-in gab eine nicht endliche Zahl oder eine negative Kraft oder Tiefe zurück</translation>
    </message>
    <message>
        <source>the compute device had no answer in time, and the processor evaluated the contacts</source>
        <translation>das Rechengerät antwortete nicht rechtzeitig; der Prozessor wertete die Kontakte aus</translation>
    </message>
    <message>
        <source>the contact changed faster than its computation followed</source>
        <translation>der Kontakt änderte sich schneller, als die Berechnung folgte</translation>
    </message>
    <message>
        <source>the contact was wider than the region that is computed</source>
        <translation>der Kontakt war breiter als der berechnete Bereich</translation>
    </message>
    <message>
        <source>the tip was pressed in too deep for the law of small strains</source>
        <translation>die Spitze war für das Gesetz kleiner Dehnungen zu tief eingedrückt</translation>
    </message>
</context>
<context>
    <name>asperity::MetadataDialog</name>
    <message>
        <source>Metadata of the study</source>
        <translation>Metadaten der Studie</translation>
    </message>
    <message>
        <source>Exports include the metadata: data archives require authors and a licence.</source>
        <translation>Exporte enthalten die Metadaten: Datenarchive verlangen Autorinnen und Autoren und eine Lizenz.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>asperity::MetadataFields</name>
    <message>
        <source>Family, Given; Family, Given</source>
        <translation>Nachname, Vorname; Nachname, Vorname</translation>
    </message>
    <message>
        <source>Authors</source>
        <translation>Autorinnen und Autoren</translation>
    </message>
    <message>
        <source>for example: CC-BY-4.0</source>
        <translation>zum Beispiel: CC-BY-4.0</translation>
    </message>
    <message>
        <source>Licence of the data</source>
        <translation>Lizenz der Daten</translation>
    </message>
    <message>
        <source>committee and number of the approval</source>
        <translation>Kommission und Nummer des Votums</translation>
    </message>
    <message>
        <source>Ethics approval</source>
        <translation>Ethikvotum</translation>
    </message>
</context>
<context>
    <name>asperity::MirrorFrame</name>
    <message>
        <source>PARTICIPANT&apos;S VIEW</source>
        <translation>ANSICHT DER VERSUCHSPERSON</translation>
    </message>
    <message>
        <source>The participant&apos;s window is not open.</source>
        <translation>Das Fenster der Versuchsperson ist nicht offen.</translation>
    </message>
</context>
<context>
    <name>asperity::ModeBand</name>
    <message>
        <source>PILOT: not study data</source>
        <translation>PILOT: keine Studiendaten</translation>
    </message>
    <message>
        <source>SIMULATED: no human participant</source>
        <translation>SIMULIERT: kein Mensch</translation>
    </message>
</context>
<context>
    <name>asperity::MotionPicture</name>
    <message>
        <source>MOTION mm</source>
        <translation>BEWEGUNG mm</translation>
    </message>
    <message>
        <source>SENT FORCE N</source>
        <translation>GESENDETE KRAFT N</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>TOP VIEW mm</source>
        <translation>DRAUFSICHT mm</translation>
    </message>
    <message>
        <source>FRONT VIEW mm</source>
        <translation>VORDERANSICHT mm</translation>
    </message>
</context>
<context>
    <name>asperity::NavigationList</name>
    <message>
        <source>Pages of the study</source>
        <translation>Seiten der Studie</translation>
    </message>
</context>
<context>
    <name>asperity::NewStudyDialog</name>
    <message>
        <source>Create a study</source>
        <translation>Studie anlegen</translation>
    </message>
    <message>
        <source>A study is a folder with its protocols, its stimuli, and all responses and recordings.</source>
        <translation>Eine Studie ist ein Ordner mit ihren Protokollen, ihren Reizen und allen Antworten und Aufzeichnungen.</translation>
    </message>
    <message>
        <source>for example: Rough surfaces 2026</source>
        <translation>zum Beispiel: Raue Oberflächen 2026</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Parent folder</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Create study</source>
        <translation>Studie anlegen</translation>
    </message>
    <message>
        <source>Folder for the study</source>
        <translation>Ordner für die Studie</translation>
    </message>
    <message>
        <source>Enter a name for the study.</source>
        <translation>Einen Namen für die Studie eingeben.</translation>
    </message>
    <message>
        <source>%1 is already a study. Open it, or choose another name.</source>
        <translation>%1 ist bereits eine Studie. Sie öffnen, oder einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1 already exists and is not an empty folder. Choose another name or another parent folder, or move the other files out of that folder.</source>
        <translation>%1 existiert bereits und ist kein leerer Ordner. Einen anderen Namen oder einen anderen übergeordneten Ordner wählen, oder die anderen Dateien aus diesem Ordner verschieben.</translation>
    </message>
    <message>
        <source>Create here</source>
        <translation>Hier anlegen</translation>
    </message>
    <message>
        <source>%1 is an empty folder. It will become the study.</source>
        <translation>%1 ist ein leerer Ordner. Er wird zur Studie.</translation>
    </message>
    <message>
        <source>The study&apos;s folder cannot be named “%1”; choose another name.</source>
        <translation>Der Ordner der Studie kann nicht „%1“ heißen; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Enter the full path of the folder, beginning with “/” or “~”.</source>
        <translation>Den vollständigen Pfad des Ordners eingeben; er beginnt mit „/“ oder „~“.</translation>
    </message>
    <message>
        <source>The study will be created in %1.</source>
        <translation>Die Studie wird in %1 angelegt.</translation>
    </message>
</context>
<context>
    <name>asperity::NoiseCheck</name>
    <message>
        <source>This protocol uses no masking noise. Cues are played nevertheless.</source>
        <translation>Dieses Protokoll verwendet kein Maskierrauschen. Signale werden dennoch abgespielt.</translation>
    </message>
    <message>
        <source>The protocol requires white noise of %1 dB(A) at the ear.</source>
        <translation>Das Protokoll verlangt weißes Rauschen mit %1 dB(A) am Ohr.</translation>
    </message>
    <message>
        <source>The protocol requires pink noise of %1 dB(A) at the ear.</source>
        <translation>Das Protokoll verlangt rosa Rauschen mit %1 dB(A) am Ohr.</translation>
    </message>
    <message>
        <source>The protocol requires white noise and states no level.</source>
        <translation>Das Protokoll verlangt weißes Rauschen und gibt keinen Pegel an.</translation>
    </message>
    <message>
        <source>The protocol requires pink noise and states no level.</source>
        <translation>Das Protokoll verlangt rosa Rauschen und gibt keinen Pegel an.</translation>
    </message>
    <message>
        <source>Play noise</source>
        <translation>Rauschen spielen</translation>
    </message>
    <message>
        <source>Play a cue</source>
        <translation>Signal spielen</translation>
    </message>
    <message>
        <source>Relative to the highest level that the sound card can play</source>
        <translation>Bezogen auf den höchsten Pegel, den die Soundkarte ausgeben kann</translation>
    </message>
    <message>
        <source>&amp;Gain</source>
        <translation>&amp;Verstärkung</translation>
    </message>
    <message>
        <source> dB(A)</source>
        <translation> dB(A)</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>&amp;Level at the ear</source>
        <translation>Pe&amp;gel am Ohr</translation>
    </message>
    <message>
        <source>Experimenter who read the sound level meter</source>
        <translation>Versuchsleitung am Schallpegelmesser</translation>
    </message>
    <message>
        <source>&amp;Verified by</source>
        <translation>Geprüft v&amp;on</translation>
    </message>
    <message>
        <source>Stop noise</source>
        <translation>Rauschen stoppen</translation>
    </message>
    <message>
        <source>There is no sound output. Connect headphones to play noise and cues.</source>
        <translation>Es gibt keine Tonausgabe. Kopfhörer anschließen, um Rauschen und Signale abzuspielen.</translation>
    </message>
    <message>
        <source>The level of the noise at the ear was not measured; measure it, and enter it.</source>
        <translation>Der Pegel des Rauschens am Ohr wurde nicht gemessen; den Pegel messen und eingeben.</translation>
    </message>
    <message>
        <source>The noise was measured at %1 dB(A): levels above %2 dB(A) can damage hearing. Lower the gain, and measure again.</source>
        <translation>Das Rauschen wurde mit %1 dB(A) gemessen: Pegel über %2 dB(A) können das Gehör schädigen. Die Verstärkung verringern und erneut messen.</translation>
    </message>
    <message>
        <source>The noise was measured at %1 dB(A); the protocol requires %2 dB(A). Change the gain, and measure again.</source>
        <translation>Das Rauschen wurde mit %1 dB(A) gemessen; das Protokoll verlangt %2 dB(A). Die Verstärkung ändern und erneut messen.</translation>
    </message>
    <message>
        <source>The experimenter who measured the noise has not been entered; enter the name.</source>
        <translation>Es ist nicht angegeben, wer das Rauschen gemessen hat; den Namen eingeben.</translation>
    </message>
    <message>
        <source>%1 dB</source>
        <translation>%1 dB</translation>
    </message>
    <message>
        <source>Sound output: %1.</source>
        <translation>Tonausgabe: %1.</translation>
    </message>
    <message>
        <source>%1 produces no sound. Connect it again, or choose another sound output in the settings of the computer.</source>
        <translation>%1 gibt keinen Ton aus. Neu anschließen oder in den Einstellungen des Rechners eine andere Tonausgabe wählen.</translation>
    </message>
</context>
<context>
    <name>asperity::NotesPanel</name>
    <message>
        <source>NOTES</source>
        <translation>NOTIZEN</translation>
    </message>
    <message>
        <source>Note (F2); Return stores it</source>
        <translation>Notiz (F2); Eingabetaste speichert</translation>
    </message>
    <message>
        <source>Adds the note “%1”</source>
        <translation>Fügt die Notiz „%1“ hinzu</translation>
    </message>
    <message>
        <source>Keep as phrase</source>
        <translation>Als Textbaustein speichern</translation>
    </message>
    <message>
        <source>Adds the note “%1”. Right-click to remove the phrase.</source>
        <translation>Fügt die Notiz „%1“ hinzu. Ein Rechtsklick entfernt den Textbaustein.</translation>
    </message>
    <message>
        <source>Remove this phrase</source>
        <translation>Diesen Textbaustein entfernen</translation>
    </message>
    <message>
        <source>earlier  %1</source>
        <translation>zuvor  %1</translation>
    </message>
    <message>
        <source>Adds a button for this note, in later sessions too</source>
        <translation>Legt für diese Notiz eine Schaltfläche an, auch in späteren Sitzungen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
</context>
<context>
    <name>asperity::NumbersField</name>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>“%1” is not a number; enter %2 from %3 to %4</source>
        <translation>„%1“ ist keine Zahl; geben Sie %2 von %3 bis %4 ein</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>größer als %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>kleiner als %1</translation>
    </message>
    <message>
        <source>“%1” is not a number; enter %2</source>
        <translation>„%1“ ist keine Zahl; geben Sie %2 ein</translation>
    </message>
</context>
<context>
    <name>asperity::ObjectRows</name>
    <message>
        <source>Remove: the default applies</source>
        <translation>Entfernen: Die Vorgabe gilt</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>„%1“ entfernen</translation>
    </message>
    <message>
        <source>+ %1</source>
        <translation>+ %1</translation>
    </message>
    <message>
        <source>Further settings (%1)</source>
        <translation>Weitere Einstellungen (%1)</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Hide unset settings</source>
        <translation>Weniger Einstellungen</translation>
    </message>
</context>
<context>
    <name>asperity::ParameterForm</name>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>↺ Reset</source>
        <translation>↺ Zurücksetzen</translation>
    </message>
    <message>
        <source>The default is %1.</source>
        <translation>Die Vorgabe ist %1.</translation>
    </message>
</context>
<context>
    <name>asperity::ParticipantCard</name>
    <message>
        <source>Participant</source>
        <translation>Versuchsperson</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Already in the study</source>
        <translation>Schon in der Studie</translation>
    </message>
    <message>
        <source>Label instead of a name *</source>
        <translation>Kürzel statt eines Namens *</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Participant *</source>
        <translation>Versuchsperson *</translation>
    </message>
    <message>
        <source>Virtual</source>
        <translation>Virtuell</translation>
    </message>
    <message>
        <source>Session %1 of this protocol, begun %2, is unfinished.</source>
        <translation>Sitzung %1 dieses Protokolls, begonnen %2, ist unvollständig.</translation>
    </message>
    <message>
        <source>No participant is chosen; choose one.</source>
        <translation>Es ist keine Versuchsperson gewählt; eine wählen.</translation>
    </message>
    <message>
        <source>The new participant has no label; enter one.</source>
        <translation>Die neue Versuchsperson hat kein Kürzel; eines eingeben.</translation>
    </message>
    <message>
        <source>%1 years</source>
        <translation>%1 Jahre</translation>
    </message>
    <message>
        <source>female</source>
        <translation>weiblich</translation>
    </message>
    <message>
        <source>male</source>
        <translation>männlich</translation>
    </message>
    <message>
        <source>left-handed</source>
        <translation>linkshändig</translation>
    </message>
    <message>
        <source>right-handed</source>
        <translation>rechtshändig</translation>
    </message>
    <message>
        <source>Session %1 of this protocol, on a simulated clock, is unfinished.</source>
        <translation>Sitzung %1 dieses Protokolls, mit simulierter Uhr, ist unvollständig.</translation>
    </message>
    <message>
        <source>Reason for resuming *</source>
        <translation>Grund für die Fortsetzung *</translation>
    </message>
    <message>
        <source>The label must consist of 1 to 32 letters and digits (0-9, A-Z, a-z) and must not begin with “virtual”.</source>
        <translation>Das Kürzel muss aus 1 bis 32 Buchstaben und Ziffern bestehen (0-9, A-Z, a-z) und darf nicht mit „virtual“ beginnen.</translation>
    </message>
    <message>
        <source>%1 is already in the study: choose it under “Already in the study”, or enter another label.</source>
        <translation>%1 ist schon in der Studie: unter „Schon in der Studie“ auswählen oder ein anderes Kürzel eingeben.</translation>
    </message>
    <message>
        <source>Session %1, on a simulated clock, will be resumed; trials completed and stored: %2 of %3.</source>
        <translation>Sitzung %1, mit simulierter Uhr, wird fortgesetzt; Durchgänge abgeschlossen und gespeichert: %2 von %3.</translation>
    </message>
    <message>
        <source>Session %1, begun %2, will be resumed; trials completed and stored: %3 of %4.</source>
        <translation>Sitzung %1, begonnen %2, wird fortgesetzt; Durchgänge abgeschlossen und gespeichert: %3 von %4.</translation>
    </message>
    <message>
        <source>Resume session %1 (trials completed: %2 of %3)</source>
        <translation>Sitzung %1 fortsetzen (Durchgänge abgeschlossen: %2 von %3)</translation>
    </message>
    <message>
        <source>No group is chosen; choose one.</source>
        <translation>Es ist keine Gruppe gewählt; eine wählen.</translation>
    </message>
</context>
<context>
    <name>asperity::ParticipantView</name>
    <message>
        <source>Participant&apos;s view</source>
        <translation>Ansicht der Versuchsperson</translation>
    </message>
    <message>
        <source>Mirror of the participant&apos;s view</source>
        <translation>Spiegel der Ansicht der Versuchsperson</translation>
    </message>
</context>
<context>
    <name>asperity::ParticipantWindow</name>
    <message>
        <source>Participant</source>
        <translation>Versuchsperson</translation>
    </message>
</context>
<context>
    <name>asperity::ParticipantsPage</name>
    <message>
        <source>Participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Kürzel</translation>
    </message>
    <message>
        <source>Age, years</source>
        <translation>Alter, Jahre</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Handedness</source>
        <translation>Händigkeit</translation>
    </message>
    <message>
        <source>Sessions completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Unfinished</source>
        <translation>Unvollständig</translation>
    </message>
    <message>
        <source>Last session</source>
        <translation>Letzte Sitzung</translation>
    </message>
    <message>
        <source>Show sessions</source>
        <translation>Sitzungen zeigen</translation>
    </message>
    <message>
        <source>Human %1</source>
        <translation>Menschlich %1</translation>
    </message>
    <message>
        <source>Virtual %1</source>
        <translation>Virtuell %1</translation>
    </message>
    <message>
        <source>%1 virtual</source>
        <translation>%1 virtuell</translation>
    </message>
    <message>
        <source>Withdraw…</source>
        <translation>Teilnahme zurückziehen…</translation>
    </message>
    <message>
        <source>Exclude the participant&apos;s data from all use, or delete them from the study.</source>
        <translation>Die Daten der Versuchsperson nicht mehr verwenden oder aus der Studie löschen.</translation>
    </message>
    <message>
        <source>%1 (withdrawn)</source>
        <translation>%1 (zurückgezogen)</translation>
    </message>
    <message>
        <source>A participant is added when their first session starts: choose a protocol on the Protocols page and press “Start session…”. A label is suggested there, and the protocol&apos;s questions are asked.</source>
        <translation>Eine Versuchsperson kommt hinzu, wenn ihre erste Sitzung startet: auf der Seite „Protokolle“ ein Protokoll wählen und „Sitzung starten…“ drücken. Das Kürzel wird vorgeschlagen, die Fragen des Protokolls werden dort gestellt.</translation>
    </message>
    <message>
        <source>No participants yet</source>
        <translation>Noch keine Versuchspersonen</translation>
    </message>
    <message>
        <source>Next suggested participant label: %1.</source>
        <translation>Nächstes vorgeschlagenes Kürzel: %1.</translation>
    </message>
    <message>
        <source>Select a participant to see their answers and sessions.</source>
        <translation>Eine Versuchsperson auswählen, um ihre Antworten und Sitzungen zu sehen.</translation>
    </message>
</context>
<context>
    <name>asperity::PathPlots</name>
    <message>
        <source>x, mm</source>
        <translation>x, mm</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>No surface was presented.</source>
        <translation>Es wurde keine Oberfläche dargeboten.</translation>
    </message>
    <message>
        <source>No contact was long enough for a spectrum.</source>
        <translation>Kein Kontakt war lang genug für ein Spektrum.</translation>
    </message>
    <message>
        <source>PATH from above, y mm</source>
        <translation>WEG von oben, y mm</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>SPECTRUM of the sent force, N/√Hz</source>
        <translation>SPEKTRUM der gesendeten Kraft, N/√Hz</translation>
    </message>
    <message>
        <source>, in its longest contact of %1 s</source>
        <translation>, im längsten Kontakt von %1 s</translation>
    </message>
    <message>
        <source>, each in its longest contact</source>
        <translation>, jeweils im längsten Kontakt</translation>
    </message>
    <message>
        <source>SPECTRUM of the rendered force (no force was sent), N/√Hz</source>
        <translation>SPEKTRUM der berechneten Kraft (es wurde keine gesendet), N/√Hz</translation>
    </message>
</context>
<context>
    <name>asperity::PlanBars</name>
    <message>
        <source>at most %1 trials</source>
        <translation>höchstens %1 Durchgänge</translation>
    </message>
    <message>
        <source>1 trial</source>
        <translation>1 Durchgang</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Durchgänge</translation>
    </message>
    <message>
        <source>%1: %2, about %3</source>
        <translation>%1: %2, etwa %3</translation>
    </message>
    <message>
        <source>break: at least %1</source>
        <translation>Pause: mindestens %1</translation>
    </message>
    <message>
        <source>texts, checks and questions: about %1</source>
        <translation>Texte, Prüfungen und Fragen: etwa %1</translation>
    </message>
    <message>
        <source>Blocks and breaks of the session</source>
        <translation>Blöcke und Pausen der Sitzung</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>asperity::PlanModel</name>
    <message>
        <source>Block %1 of %2, %3</source>
        <translation>Block %1 von %2, %3</translation>
    </message>
    <message>
        <source>%1, previously: %2</source>
        <translation>%1, zuvor: %2</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>%1 · attempt %2</source>
        <translation>%1 · Versuch %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>asperity::PlanPreview</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>the force at rest</source>
        <translation>die Kraft in Ruhe</translation>
    </message>
    <message>
        <source>the device</source>
        <translation>das Gerät</translation>
    </message>
    <message>
        <source>break</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>at least %1 s: %2</source>
        <translation>mindestens %1 s: %2</translation>
    </message>
    <message>
        <source>questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Surfaces in order</source>
        <translation>Reihenfolge der Oberflächen</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Options as shown</source>
        <translation>Antwortmöglichkeiten, wie gezeigt</translation>
    </message>
    <message>
        <source>1 contact</source>
        <translation>1 Kontakt</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 Kontakte</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>at most %1 without a break</source>
        <translation>höchstens %1 ohne Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Another order</source>
        <translation>Andere Reihenfolge</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>Correct response</source>
        <translation>Richtige Antwort</translation>
    </message>
    <message>
        <source>Random orders are drawn separately for every session.</source>
        <translation>Zufällige Reihenfolgen werden für jede Sitzung neu gezogen.</translation>
    </message>
    <message>
        <source>Counterbalancing row: each new participant is assigned the least used one.</source>
        <translation>Zeile der Ausbalancierung: Jede neue Versuchsperson erhält die bisher am seltensten verwendete.</translation>
    </message>
    <message>
        <source>Selected step</source>
        <translation>Ausgewählter Schritt</translation>
    </message>
    <message>
        <source>Generated trial list</source>
        <translation>Erzeugte Durchgangsliste</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Group of the participant</source>
        <translation>Gruppe der Versuchsperson</translation>
    </message>
    <message>
        <source>example of a session, whose levels depend on the responses</source>
        <translation>Beispiel einer Sitzung, deren Stufen von den Antworten abhängen</translation>
    </message>
    <message>
        <source>catch trial</source>
        <translation>Kontrolldurchgang</translation>
    </message>
    <message>
        <source>track %1, step %2</source>
        <translation>Folge %1, Schritt %2</translation>
    </message>
    <message>
        <source>repetition %1</source>
        <translation>Wiederholung %1</translation>
    </message>
    <message>
        <source>Trial %1, %2, %3</source>
        <translation>Durchgang %1, %2, %3</translation>
    </message>
    <message>
        <source>if %1:</source>
        <translation>wenn %1:</translation>
    </message>
    <message>
        <source>only %1:</source>
        <translation>nur %1:</translation>
    </message>
    <message>
        <source>anchor at the start</source>
        <translation>Anker am Anfang</translation>
    </message>
    <message>
        <source>anchor in the middle</source>
        <translation>Anker in der Mitte</translation>
    </message>
    <message>
        <source>anchor at the end</source>
        <translation>Anker am Ende</translation>
    </message>
    <message>
        <source>The plan is being made…</source>
        <translation>Der Plan wird erstellt…</translation>
    </message>
</context>
<context>
    <name>asperity::PlanTable</name>
    <message>
        <source>PLAN</source>
        <translation>PLAN</translation>
    </message>
    <message>
        <source>Show the trial under way</source>
        <translation>Laufenden Durchgang zeigen</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
</context>
<context>
    <name>asperity::PluginLoading</name>
    <message>
        <source>Plug-ins</source>
        <translation>Plug-ins</translation>
    </message>
    <message>
        <source>Loading and checking the plug-ins</source>
        <translation>Plug-ins werden geladen und geprüft</translation>
    </message>
    <message>
        <source>The conformance suite takes from a second to minutes for each plug-in.</source>
        <translation>Die Konformitätsprüfungen dauern je Plug-in zwischen einer Sekunde und einigen Minuten.</translation>
    </message>
    <message>
        <source>Progress of the checks</source>
        <translation>Fortschritt der Prüfungen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
</context>
<context>
    <name>asperity::PluginsDialog</name>
    <message>
        <source>Plug-ins</source>
        <translation>Plug-ins</translation>
    </message>
    <message>
        <source>Plug-ins with force models</source>
        <translation>Plug-ins mit Kraftmodellen</translation>
    </message>
    <message>
        <source>A plug-in is a program: it can do everything that you can do on this computer. Add only plug-ins from a source that you trust. They are checked and loaded when a study is opened.</source>
        <translation>Ein Plug-in ist ein Programm: Es kann alles, was Sie auf diesem Rechner können. Nur Plug-ins aus vertrauenswürdiger Quelle hinzufügen. Sie werden geprüft und geladen, wenn eine Studie geöffnet wird.</translation>
    </message>
    <message>
        <source>Files of the plug-ins</source>
        <translation>Dateien der Plug-ins</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Add plug-ins</source>
        <translation>Plug-ins hinzufügen</translation>
    </message>
    <message>
        <source>Shared libraries (*.so)</source>
        <translation>Gemeinsame Bibliotheken (*.so)</translation>
    </message>
</context>
<context>
    <name>asperity::PrecisionView</name>
    <message>
        <source>Power</source>
        <translation>Teststärke</translation>
    </message>
    <message>
        <source>Width of the 95 % CI, median</source>
        <translation>Breite des 95-%-KI, Median</translation>
    </message>
    <message>
        <source>Width of the 95 % CI, 90th percentile</source>
        <translation>Breite des 95-%-KI, 90. Perzentil</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Standardfehler</translation>
    </message>
    <message>
        <source>too few studies so far</source>
        <translation>bisher zu wenige Studien</translation>
    </message>
    <message>
        <source>%1 [%2, %3]</source>
        <translation>%1 [%2; %3]</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>Assumptions</source>
        <translation>Annahmen</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Präzision</translation>
    </message>
    <message>
        <source>Value [95 % Monte-Carlo CI]</source>
        <translation>Wert [95-%-Monte-Carlo-KI]</translation>
    </message>
    <message>
        <source>rounds of %1</source>
        <translation>Runden zu je %1</translation>
    </message>
    <message>
        <source>Participants until every row of counterbalancing occurs equally often in every group.</source>
        <translation>Versuchspersonen, bis jede Zeile der Ausbalancierung in jeder Gruppe gleich oft vorkommt.</translation>
    </message>
    <message>
        <source>The studies could not be simulated: %1</source>
        <translation>Die Studien konnten nicht simuliert werden: %1</translation>
    </message>
    <message>
        <source>Studies cannot be simulated here: %1</source>
        <translation>Studien lassen sich hier nicht simulieren: %1</translation>
    </message>
    <message>
        <source>No block of the protocol has responses that an analysis counts. Add a block of trials.</source>
        <translation>Kein Block des Protokolls hat Antworten, die eine Auswertung zählt. Einen Block mit Durchgängen ergänzen.</translation>
    </message>
    <message>
        <source>Correct these values: %1</source>
        <translation>Diese Werte korrigieren: %1</translation>
    </message>
    <message>
        <source>State these values to see the precision: %1</source>
        <translation>Für die Präzision diese Werte angeben: %1</translation>
    </message>
    <message>
        <source>No studies are simulated while the device is in use.</source>
        <translation>Solange das Gerät benutzt wird, werden keine Studien simuliert.</translation>
    </message>
    <message>
        <source>The protocol is being read…</source>
        <translation>Das Protokoll wird gelesen…</translation>
    </message>
    <message>
        <source>%1 of %2 simulated studies</source>
        <translation>%1 von %2 simulierten Studien</translation>
    </message>
    <message>
        <source>%1. The protocol has no family of tests, so there is no power: declare one in “analysis”.</source>
        <translation>%1. Das Protokoll hat keine Familie von Tests, daher gibt es keine Teststärke: eine in „analysis“ angeben.</translation>
    </message>
    <message>
        <source>at least one of: %1</source>
        <translation>mindestens einer von: %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1; without p in %2: %3</source>
        <translation>%1; ohne p in %2: %3</translation>
    </message>
    <message>
        <source>Simulate %1 studies</source>
        <translation>%1 Studien simulieren</translation>
    </message>
    <message>
        <source>There is no command until the values are stated.</source>
        <translation>Solange Werte fehlen, gibt es keinen Befehl.</translation>
    </message>
    <message>
        <source>The command reads the saved file. Standard errors are shown here only.</source>
        <translation>Der Befehl liest die gespeicherte Datei. Standardfehler werden nur hier gezeigt.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>asperity::ProfileView</name>
    <message>
        <source>Measured on %1</source>
        <translation>Gemessen am %1</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, force at most %3 N.</source>
        <translation>%1 bei %2 Hz, Kraft höchstens %3 N.</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>Along %1.</source>
        <translation>Entlang %1.</translation>
    </message>
    <message>
        <source>Simulated device: its timing is reported, not evaluated.</source>
        <translation>Simuliertes Gerät: Das Zeitverhalten wird angegeben, aber nicht bewertet.</translation>
    </message>
</context>
<context>
    <name>asperity::ProgramChooser</name>
    <message>
        <source>External program</source>
        <translation>Externes Programm</translation>
    </message>
    <message>
        <source>A program of the laboratory states the levels of this protocol. Choose the program.</source>
        <translation>Ein Programm des Labors gibt die Stufen dieses Protokolls an. Das Programm wählen.</translation>
    </message>
    <message>
        <source>Program *</source>
        <translation>Programm *</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for the external program</source>
        <translation>Das externe Programm suchen</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Argumente</translation>
    </message>
    <message>
        <source>Separated by spaces; an argument that contains spaces is in quotation marks.</source>
        <translation>Durch Leerzeichen getrennt; ein Argument mit Leerzeichen steht in Anführungszeichen.</translation>
    </message>
    <message>
        <source>No external program is chosen; choose the one that states the levels.</source>
        <translation>Kein externes Programm ist gewählt; das Programm wählen, das die Stufen angibt.</translation>
    </message>
    <message>
        <source>Choose the external program</source>
        <translation>Externes Programm wählen</translation>
    </message>
</context>
<context>
    <name>asperity::ProgressCell</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolEditorPage</name>
    <message>
        <source>The protocol is being saved.</source>
        <translation>Das Protokoll wird gespeichert.</translation>
    </message>
    <message>
        <source>The file is saved, but no session can be run with it: it has %1.</source>
        <translation>Die Datei ist gespeichert, aber mit ihr kann keine Sitzung durchgeführt werden: Sie hat %1.</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Methoden</translation>
    </message>
    <message>
        <source>Which method answers which question, and its library protocol</source>
        <translation>Welche Methode welche Frage beantwortet, mit ihrem Bibliotheksprotokoll</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>No protocol open</source>
        <translation>Kein Protokoll geöffnet</translation>
    </message>
    <message>
        <source>Show the protocols</source>
        <translation>Protokolle zeigen</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>wird geprüft…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>← All protocols</source>
        <translation>← Alle Protokolle</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>The protocol could not be read: %1</source>
        <translation>Das Protokoll konnte nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>This file cannot be edited here without loss: it is not UTF-8, or its line endings are mixed. Save it as UTF-8 with uniform line endings in another program.</source>
        <translation>Diese Datei kann hier nicht ohne Verlust bearbeitet werden: Sie ist nicht UTF-8 oder hat gemischte Zeilenenden. Mit einem anderen Programm als UTF-8 mit einheitlichen Zeilenenden speichern.</translation>
    </message>
    <message>
        <source>Cannot be edited here</source>
        <translation>Hier nicht zu bearbeiten</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>● Unsaved changes</source>
        <translation>● Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>No unsaved changes</source>
        <translation>Alles gespeichert</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>The plan appears here once the protocol is valid. At present it has %1; the first is at %2.</source>
        <translation>Der Plan erscheint hier, sobald das Protokoll gültig ist. Derzeit enthält es %1; das erste steht bei %2.</translation>
    </message>
    <message>
        <source>The plan appears here once the text is valid. At present it has %1; the first is on line %2.</source>
        <translation>Der Plan erscheint hier, sobald der Text gültig ist. Derzeit enthält der Text %1; das erste steht in Zeile %2.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Discard the changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Keep editing</source>
        <translation>Weiter bearbeiten</translation>
    </message>
    <message>
        <source>The protocol could not be saved: %1</source>
        <translation>Das Protokoll konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Saved. If sessions were run with another text of this version, raise the version; whether they were could not be determined: %1</source>
        <translation>Gespeichert. Wenn Sitzungen mit einem anderen Text dieser Version durchgeführt wurden, die Version erhöhen; ob das der Fall ist, konnte nicht ermittelt werden: %1</translation>
    </message>
    <message>
        <source>Use the other version</source>
        <translation>Andere Fassung verwenden</translation>
    </message>
    <message>
        <source>The text of the other program is shown. Undo restores yours.</source>
        <translation>Der Text des anderen Programms wird gezeigt. „Rückgängig“ stellt den eigenen wieder her.</translation>
    </message>
    <message>
        <source>Keep my version and save</source>
        <translation>Eigene behalten und speichern</translation>
    </message>
    <message>
        <source>Keep my version</source>
        <translation>Eigene behalten</translation>
    </message>
    <message>
        <source>Raise to %1 and save</source>
        <translation>Auf %1 erhöhen und speichern</translation>
    </message>
    <message>
        <source>Save under the same version</source>
        <translation>Unter derselben Version speichern</translation>
    </message>
    <message>
        <source>Do not save yet</source>
        <translation>Noch nicht speichern</translation>
    </message>
    <message>
        <source>This study is read-only</source>
        <translation>Diese Studie ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Choose one of the study&apos;s protocols and press “Edit”.</source>
        <translation>Ein Protokoll der Studie auswählen und „Bearbeiten“ drücken.</translation>
    </message>
    <message>
        <source>Saved as %1: the file is named after the protocol.</source>
        <translation>Gespeichert als %1: Die Datei heißt wie das Protokoll.</translation>
    </message>
    <message>
        <source>One session was run with another text of version %1; raise the version to keep the data apart.</source>
        <translation>Eine Sitzung lief mit einem anderen Text der Version %1; die Version erhöhen, damit die Daten unterscheidbar bleiben.</translation>
    </message>
    <message>
        <source>%1 sessions were run with another text of version %2; raise the version to keep the data apart.</source>
        <translation>%1 Sitzungen liefen mit einem anderen Text der Version %2; die Version erhöhen, damit die Daten unterscheidbar bleiben.</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>valid, 1 warning</source>
        <translation>gültig, 1 Warnung</translation>
    </message>
    <message>
        <source>valid, %1 warnings</source>
        <translation>gültig, %1 Warnungen</translation>
    </message>
    <message>
        <source>Sessions simulated with another text of version %1: %2. They would be analysed together with new ones; raise the version to keep the data apart.</source>
        <translation>Mit einem anderen Text der Version %1 simulierte Sitzungen: %2. Sie würden mit neuen zusammen ausgewertet; die Version erhöhen, um die Daten getrennt zu halten.</translation>
    </message>
    <message>
        <source>%1 (the stimuli are examined when the device is free again)</source>
        <translation>%1 (die Reize werden untersucht, sobald das Gerät wieder frei ist)</translation>
    </message>
    <message>
        <source>%1 (the stimuli are being examined…)</source>
        <translation>%1 (die Reize werden untersucht…)</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Präzision</translation>
    </message>
    <message>
        <source>The protocol has changed meanwhile and was left as it is. Choose the rendering again.</source>
        <translation>Das Protokoll wurde inzwischen geändert und blieb unverändert. Die Wiedergabe noch einmal wählen.</translation>
    </message>
    <message>
        <source>%1 has been changed outside the editor since it was opened here.</source>
        <translation>%1 wurde seit dem Öffnen außerhalb des Editors geändert.</translation>
    </message>
    <message>
        <source>The file has been changed outside the editor and its new text is shown. Undo restores the previous text.</source>
        <translation>Die Datei wurde außerhalb des Editors geändert, und ihr neuer Text wird angezeigt. Rückgängig stellt den vorherigen Text wieder her.</translation>
    </message>
    <message>
        <source>The text is checked when the device is free again.</source>
        <translation>Der Text wird geprüft, sobald das Gerät wieder frei ist.</translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolFileActions</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>%1 has been run (%n sessions). Sessions refer to its name and its text: it can be neither renamed nor deleted. Duplicate it to create a further protocol from it.</source>
        <translation>
            <numerusform>%1 wurde durchgeführt (%n Sitzung). Sitzungen beziehen sich auf Namen und Text: Das Protokoll kann weder umbenannt noch gelöscht werden. Um ein weiteres Protokoll daraus zu erstellen, dieses duplizieren.</numerusform>
            <numerusform>%1 wurde durchgeführt (%n Sitzungen). Sitzungen beziehen sich auf Namen und Text: Das Protokoll kann weder umbenannt noch gelöscht werden. Um ein weiteres Protokoll daraus zu erstellen, dieses duplizieren.</numerusform>
        </translation>
    </message>
    <message>
        <source>The protocol could not be duplicated: %1</source>
        <translation>Das Protokoll konnte nicht dupliziert werden: %1</translation>
    </message>
    <message>
        <source>New name of %1 (the file is renamed too):</source>
        <translation>Neuer Name von %1 (auch die Datei wird umbenannt):</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete %1? It was never run. The file cannot be restored.</source>
        <translation>%1 löschen? Das Protokoll wurde nie durchgeführt. Die Datei lässt sich nicht wiederherstellen.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolForm</name>
    <message>
        <source>Pages of the form</source>
        <translation>Seiten des Formulars</translation>
    </message>
    <message>
        <source>the text is not an object {…}</source>
        <translation>der Text ist kein Objekt {…}</translation>
    </message>
    <message>
        <source>The text is not valid JSON. The form shows the last valid text and cannot be edited. Correct it in the text: %1</source>
        <translation>Der Text ist kein gültiges JSON. Das Formular zeigt den letzten gültigen Text und kann nicht bearbeitet werden. Im Text korrigieren: %1</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Felder</translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolViews</name>
    <message>
        <source>Form</source>
        <translation>Formular</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Text of the protocol</source>
        <translation>Text des Protokolls</translation>
    </message>
    <message>
        <source>Help for the key at the cursor.</source>
        <translation>Hilfe zum Schlüssel an der Schreibmarke.</translation>
    </message>
    <message>
        <source>Switches to the other view: %1</source>
        <translation>Wechselt zur anderen Ansicht: %1</translation>
    </message>
</context>
<context>
    <name>asperity::ProtocolsPage</name>
    <message>
        <source>1 trial</source>
        <translation>1 Durchgang</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Durchgänge</translation>
    </message>
    <message>
        <source>1 block</source>
        <translation>1 Block</translation>
    </message>
    <message>
        <source>%1 blocks</source>
        <translation>%1 Blöcke</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>%1 sessions each</source>
        <translation>je %1 Sitzungen</translation>
    </message>
    <message>
        <source>Not run yet.</source>
        <translation>Noch nicht durchgeführt.</translation>
    </message>
    <message>
        <source>Last run %1, %2, %3.</source>
        <translation>Zuletzt durchgeführt %1, %2, %3.</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>Protocols</source>
        <translation>Protokolle</translation>
    </message>
    <message>
        <source>No protocols yet</source>
        <translation>Noch keine Protokolle</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Start session…</source>
        <translation>Sitzung starten…</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Preview plan</source>
        <translation>Plan ansehen</translation>
    </message>
    <message>
        <source>Simulate…</source>
        <translation>Simulieren…</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>The protocol could not be created: %1</source>
        <translation>Das Protokoll konnte nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>Close the plan</source>
        <translation>Plan schließen</translation>
    </message>
    <message>
        <source>Last run on a simulated clock, %1, %2.</source>
        <translation>Zuletzt mit simulierter Uhr durchgeführt, %1, %2.</translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation>Schreibgeschützt</translation>
    </message>
    <message>
        <source>This study is read-only: no session can be stored. Copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt: Es kann keine Sitzung gespeichert werden. Die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>The protocols are being read.</source>
        <translation>Die Protokolle werden gelesen.</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>A protocol defines stimuli, tasks and trial order. Begin with one from the library, or copy a protocol file into the study&apos;s folder “protocols”: it appears here at once.</source>
        <translation>Ein Protokoll legt Reize, Aufgaben und die Reihenfolge der Durchgänge fest. Mit einem aus der Bibliothek beginnen oder eine Protokolldatei in den Ordner „protocols“ der Studie kopieren: Sie erscheint hier sofort.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Fix the problems listed below first.</source>
        <translation>Zuerst die unten aufgeführten Probleme beheben.</translation>
    </message>
    <message>
        <source>valid, 1 warning</source>
        <translation>gültig, 1 Warnung</translation>
    </message>
    <message>
        <source>valid, %1 warnings</source>
        <translation>gültig, %1 Warnungen</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Block %1: %2.</source>
        <translation>Block %1: %2.</translation>
    </message>
    <message>
        <source>The stimuli are examined when the device is free again.</source>
        <translation>Die Reize werden untersucht, sobald das Gerät wieder frei ist.</translation>
    </message>
    <message>
        <source>Examining stimuli: %1 of %2</source>
        <translation>Untersuchung der Reize: %1 von %2</translation>
    </message>
    <message>
        <source>Create from template…</source>
        <translation>Aus Vorlage erstellen…</translation>
    </message>
    <message numerus="yes">
        <source>Simulate %n participants</source>
        <translation>
            <numerusform>%n Versuchsperson simulieren</numerusform>
            <numerusform>%n Versuchspersonen simulieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Virtual participants, in the background. Their results are then shown. “Simulate…” offers another number.</source>
        <translation>Virtuelle Versuchspersonen, im Hintergrund. Danach werden ihre Ergebnisse gezeigt. „Simulieren…“ bietet eine andere Anzahl an.</translation>
    </message>
    <message>
        <source>Check the protocol</source>
        <translation>Protokoll prüfen</translation>
    </message>
    <message>
        <source>Try it with the mouse</source>
        <translation>Mit der Maus ausprobieren</translation>
    </message>
    <message>
        <source>Two trials, without force, in a temporary copy. Nothing is stored.</source>
        <translation>Zwei Durchgänge, ohne Kraft, in einer vorübergehenden Kopie. Nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>as group %1</source>
        <translation>als Gruppe %1</translation>
    </message>
    <message>
        <source>Group of the trial with the mouse</source>
        <translation>Gruppe des Versuchs mit der Maus</translation>
    </message>
    <message>
        <source>Group of the participant in the trial with the mouse</source>
        <translation>Gruppe der Versuchsperson im Versuch mit der Maus</translation>
    </message>
</context>
<context>
    <name>asperity::QuestionForm</name>
    <message>
        <source>* required</source>
        <translation>* Pflichtangabe</translation>
    </message>
    <message>
        <source>%1 *</source>
        <translation>%1 *</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
</context>
<context>
    <name>asperity::ReasonForm</name>
    <message>
        <source>Choose a reason above or enter one</source>
        <translation>Oben einen Grund wählen oder einen eingeben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
</context>
<context>
    <name>asperity::RecipePanel</name>
    <message>
        <source>The picture varies mostly in one direction: either the surface has a grain, or the picture was taken in light from one side. See the end of this list.</source>
        <translation>Das Bild ändert sich vor allem in einer Richtung: Entweder hat die Oberfläche eine Maserung, oder das Licht kam von einer Seite. Siehe das Ende dieser Liste.</translation>
    </message>
    <message>
        <source>The picture has narrow bright parts. If they are low, as light mortar is, the dark parts stand out.</source>
        <translation>Das Bild hat schmale helle Teile. Liegen sie tief, wie heller Mörtel, stehen die dunklen Teile hervor.</translation>
    </message>
    <message>
        <source>&lt;b&gt;What does the photograph show?&lt;/b&gt;</source>
        <translation>&lt;b&gt;Was zeigt das Foto?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Relief: bright parts stand out</source>
        <translation>Relief: Helles steht hervor</translation>
    </message>
    <message>
        <source>Relief: dark parts stand out</source>
        <translation>Relief: Dunkles steht hervor</translation>
    </message>
    <message>
        <source>Paint, print or stains</source>
        <translation>Farbe, Druck oder Flecken</translation>
    </message>
    <message>
        <source>&lt;b&gt;Indications in the picture&lt;/b&gt;</source>
        <translation>&lt;b&gt;Hinweise im Bild&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Even out the light</source>
        <translation>Licht ausgleichen</translation>
    </message>
    <message>
        <source>Attenuate short wavelengths</source>
        <translation>Kurze Wellen abschwächen</translation>
    </message>
    <message>
        <source>Remove long wavelengths</source>
        <translation>Große Wellenlängen entfernen</translation>
    </message>
    <message>
        <source>▲ The paint becomes relief: what is felt does not correspond to the surface under it. Use it only if this is intended.</source>
        <translation>▲ Die Farbe wird zum Relief: Was gefühlt wird, entspricht nicht der Oberfläche darunter. Nur verwenden, wenn das beabsichtigt ist.</translation>
    </message>
    <message>
        <source>Dark is high: for light mortar between bricks or light sand between pebbles, in even light. On five measured surfaces the heights matched the relief only in part, and on four of them less well than the unprocessed brightness.</source>
        <translation>Dunkel ist hoch: für hellen Mörtel zwischen Ziegeln oder hellen Sand zwischen Kieseln, in gleichmäßigem Licht. Bei fünf vermessenen Oberflächen stimmten die Höhen nur zum Teil mit dem Relief überein, bei vier davon weniger gut als die unbearbeitete Helligkeit.</translation>
    </message>
    <message>
        <source>Bright is high: for a surface in even light, where grooves and gaps are dark. On five measured surfaces the heights matched the relief only in part, and on four of them less well than the unprocessed brightness. A photograph does not show the depth of the relief: set it below.</source>
        <translation>Hell ist hoch: für eine Oberfläche in gleichmäßigem Licht, deren Rillen und Lücken dunkel sind. Bei fünf vermessenen Oberflächen stimmten die Höhen nur zum Teil mit dem Relief überein, bei vier davon weniger gut als die unbearbeitete Helligkeit. Ein Foto zeigt die Tiefe des Reliefs nicht: Sie ist unten einzustellen.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Choose what the photograph shows: the sign of the heights is not determined yet.</source>
        <translation>Wählen Sie, was das Foto zeigt: Das Vorzeichen der Höhen ist noch nicht bestimmt.</translation>
    </message>
    <message>
        <source>▲ The relief is provisional: it shows bright parts as high. The picture does not determine the sign; look at the surface and choose.</source>
        <translation>▲ Das Relief ist vorläufig: Helle Stellen sind darin hoch. Das Bild bestimmt das Vorzeichen nicht; sehen Sie die Oberfläche an und wählen Sie.</translation>
    </message>
    <message>
        <source>Answer the question first: the recommended method depends on the light, and the picture does not show it.</source>
        <translation>Beantworten Sie zuerst die Frage: Das empfohlene Verfahren hängt vom Licht ab, und das Bild zeigt es nicht.</translation>
    </message>
    <message>
        <source>Recommended method: %1, with the direction of the lamp as the light azimuth. The brightness varies mostly along %2° and %3°. With the methods Wu and Brightness, the result is the slope towards the light, not the height: edges across the light become ridges and grooves, edges along it vanish.</source>
        <translation>Empfohlenes Verfahren: %1, mit der Richtung der Lampe als Azimut des Lichts. Die Helligkeit ändert sich vor allem entlang %2° und %3°. Mit den Verfahren Wu und Helligkeit ist das Ergebnis die Neigung zum Licht, nicht die Höhe: Kanten quer zum Licht werden zu Graten und Rillen, Kanten längs verschwinden.</translation>
    </message>
    <message>
        <source>Recommended method: %1 with a spectral tilt of %2, because on nine of ten measured surfaces it was closer to the relief than the unprocessed brightness.</source>
        <translation>Empfohlenes Verfahren: %1 mit einer spektralen Neigung von %2, weil es bei neun von zehn vermessenen Oberflächen dem Relief näher kam als die unbearbeitete Helligkeit.</translation>
    </message>
    <message>
        <source>Use the recommended method</source>
        <translation>Empfohlenes Verfahren verwenden</translation>
    </message>
    <message>
        <source>&lt;b&gt;Did the light come from one lamp at the side?&lt;/b&gt;</source>
        <translation>&lt;b&gt;Kam das Licht von einer Lampe an der Seite?&lt;/b&gt;</translation>
    </message>
    <message>
        <source>No: from all sides</source>
        <translation>Nein: von allen Seiten</translation>
    </message>
    <message>
        <source>Yes: from one side</source>
        <translation>Ja: von einer Seite</translation>
    </message>
</context>
<context>
    <name>asperity::RecordingView</name>
    <message>
        <source>Visible part of the recording</source>
        <translation>Sichtbarer Teil der Aufzeichnung</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Export this recording as a table…</source>
        <translation>Diese Aufzeichnung als Tabelle exportieren…</translation>
    </message>
    <message>
        <source>Whole attempt</source>
        <translation>Ganzer Versuch</translation>
    </message>
</context>
<context>
    <name>asperity::ReliefView</name>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>Drag to turn the relief. Drag with the right button to move the light. The wheel zooms. Keys: arrows, Shift and arrows, + and −, Home.</source>
        <translation>Ziehen dreht das Relief. Ziehen mit der rechten Taste bewegt das Licht. Das Rad zoomt. Tasten: Pfeile, Umschalt und Pfeile, + und −, Pos1.</translation>
    </message>
    <message>
        <source>Drag over the relief to stroke it. Drag with the right button to move the light. Arrow keys turn the relief.</source>
        <translation>Ziehen streicht über das Relief. Ziehen mit der rechten Taste bewegt das Licht. Pfeiltasten drehen das Relief.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
</context>
<context>
    <name>asperity::RenderingPanel</name>
    <message>
        <source>Name of the renderings</source>
        <translation>Name der Wiedergaben</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>The chosen force models with their values, the texture, stiffness and friction</source>
        <translation>Die gewählten Kraftmodelle mit ihren Werten, der Textur, Steifigkeit und Reibung</translation>
    </message>
    <message>
        <source>Use in an experiment…</source>
        <translation>In einem Experiment verwenden…</translation>
    </message>
    <message>
        <source>Saves the renderings, then copies the values of one of them into a protocol</source>
        <translation>Speichert die Wiedergaben und kopiert dann die Werte einer davon in ein Protokoll</translation>
    </message>
    <message>
        <source>This study is read-only; copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt; die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>Choose a force model.</source>
        <translation>Ein Kraftmodell wählen.</translation>
    </message>
    <message>
        <source>Enter a name for the renderings.</source>
        <translation>Einen Namen für die Wiedergaben eingeben.</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>Will be saved in stimuli/ as %1.</source>
        <translation>Wird in stimuli/ gespeichert als %1.</translation>
    </message>
    <message>
        <source>Saved in stimuli/: %1.</source>
        <translation>In stimuli/ gespeichert: %1.</translation>
    </message>
    <message>
        <source>The renderings were not saved: %1</source>
        <translation>Die Wiedergaben wurden nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Use at most %1 unaccented letters, digits, _ and -.</source>
        <translation>Höchstens %1 Buchstaben ohne Akzente, Ziffern, _ und - verwenden.</translation>
    </message>
</context>
<context>
    <name>asperity::ReportSaving</name>
    <message>
        <source>Save a report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>There are no sessions to report yet.</source>
        <translation>Es gibt noch keine Sitzungen für einen Bericht.</translation>
    </message>
    <message>
        <source>The report is being written.</source>
        <translation>Der Bericht wird geschrieben.</translation>
    </message>
    <message>
        <source>Methods, tables, tests and figures, as PDF or HTML.</source>
        <translation>Methoden, Tabellen, Tests und Abbildungen, als PDF oder HTML.</translation>
    </message>
    <message>
        <source>File for the report</source>
        <translation>Datei für den Bericht</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>PDF for print (*.pdf)</source>
        <translation>PDF für den Druck (*.pdf)</translation>
    </message>
    <message>
        <source>%1 already exists; nothing was written. Replace it, or save the report under another name.</source>
        <translation>%1 existiert bereits; es wurde nichts geschrieben. Die Datei ersetzen oder den Bericht unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Writing the report to %1 …</source>
        <translation>Der Bericht wird nach %1 geschrieben…</translation>
    </message>
    <message>
        <source>Writing the report was cancelled, and no report was written. To write it, save the report again.</source>
        <translation>Das Schreiben des Berichts wurde abgebrochen, und es wurde kein Bericht geschrieben. Zum Schreiben den Bericht erneut speichern.</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Der Bericht liegt in %1.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
</context>
<context>
    <name>asperity::ResponseKeys</name>
    <message>
        <source>Keys reserved for the response</source>
        <translation>Tasten für die Antwort reserviert</translation>
    </message>
</context>
<context>
    <name>asperity::ResponsePlot</name>
    <message>
        <source>frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>FREQUENCY RESPONSE mm/N, motion over force</source>
        <translation>FREQUENZGANG mm/N, Bewegung geteilt durch Kraft</translation>
    </message>
    <message>
        <source>No frequency response is stored with this profile; to measure it, test the device again.</source>
        <translation>Mit diesem Profil ist kein Frequenzgang gespeichert; um ihn zu messen, das Gerät erneut testen.</translation>
    </message>
</context>
<context>
    <name>asperity::RowTable</name>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>+ Add</source>
        <translation>+ Hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>+ Factor</source>
        <translation>+ Faktor</translation>
    </message>
    <message>
        <source>All factors occur already</source>
        <translation>Alle Faktoren kommen schon vor</translation>
    </message>
</context>
<context>
    <name>asperity::SavePanel</name>
    <message>
        <source>The photograph does not fit into the memory of this computer as a whole; scale it down and open it again</source>
        <translation>Das Foto passt als Ganzes nicht in den Speicher dieses Rechners; es verkleinern und erneut öffnen</translation>
    </message>
    <message>
        <source>Name in the study</source>
        <translation>Name in der Studie</translation>
    </message>
    <message>
        <source>Save to study</source>
        <translation>In Studie speichern</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3 µm from the lowest to the highest point, RMS %4 µm</source>
        <translation>%1 × %2 mm, %3 µm vom tiefsten bis zum höchsten Punkt, Effektivwert %4 µm</translation>
    </message>
    <message>
        <source>The relief will be saved in stimuli/ with its sidecar and its photograph.</source>
        <translation>Das Relief wird in stimuli/ gespeichert, mit Begleitdatei und Foto.</translation>
    </message>
    <message>
        <source>A relief from a file is already saved; open a photograph to make another relief.</source>
        <translation>Ein Relief aus einer Datei ist bereits gespeichert; ein Foto öffnen, um ein weiteres Relief zu erstellen.</translation>
    </message>
    <message>
        <source>Enter a name for the relief.</source>
        <translation>Einen Namen für das Relief eingeben.</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>The study has a stimulus of this name; you will be asked before it is replaced.</source>
        <translation>Die Studie hat einen Reiz dieses Namens; vor dem Ersetzen wird gefragt.</translation>
    </message>
    <message>
        <source>The study already has a stimulus “%1”. Protocols that use it would present the new one; sessions that were run keep the SHA-256 of the old one.</source>
        <translation>Die Studie hat schon einen Reiz „%1“. Protokolle, die ihn verwenden, würden den neuen darbieten; durchgeführte Sitzungen behalten den SHA-256 des alten.</translation>
    </message>
    <message>
        <source>Replace “%1”</source>
        <translation>„%1“ ersetzen</translation>
    </message>
    <message>
        <source>Saving “%1” was cancelled; to keep the relief, save it again.</source>
        <translation>Das Speichern von „%1“ wurde abgebrochen; um das Relief zu behalten, es erneut speichern.</translation>
    </message>
    <message>
        <source>Saved as stimuli/%1.png, with its sidecar and stimuli/%1_photo.png.</source>
        <translation>Gespeichert als stimuli/%1.png, mit Begleitdatei und stimuli/%1_photo.png.</translation>
    </message>
    <message>
        <source>The relief was not saved: %1</source>
        <translation>Das Relief wurde nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>This study is read-only; copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt; die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>Names ending in _photo are reserved for the photographs stored with the reliefs; choose another name.</source>
        <translation>Namen, die auf _photo enden, sind den Fotos vorbehalten, die mit den Reliefs gespeichert werden; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Use at most %1 unaccented letters, digits, _ and -.</source>
        <translation>Höchstens %1 Buchstaben ohne Akzente, Ziffern, _ und - verwenden.</translation>
    </message>
    <message>
        <source>The photograph is not stored with it.</source>
        <translation>Das Foto wird nicht mit gespeichert.</translation>
    </message>
</context>
<context>
    <name>asperity::SchemaHelp</name>
    <message>
        <source>object {…}</source>
        <translation>Objekt {…}</translation>
    </message>
    <message>
        <source>list […]</source>
        <translation>Liste […]</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>always %1</source>
        <translation>immer %1</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>eines von: %1</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>%1 or less</source>
        <translation>%1 oder weniger</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>%1 entries</source>
        <translation>%1 Einträge</translation>
    </message>
    <message>
        <source>%1 to %2 entries</source>
        <translation>%1 bis %2 Einträge</translation>
    </message>
    <message>
        <source>A comment: the program ignores it.</source>
        <translation>Ein Kommentar: Das Programm wertet ihn nicht aus.</translation>
    </message>
    <message>
        <source>required</source>
        <translation>notwendig</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>Vorgabe %1</translation>
    </message>
    <message>
        <source>from %1 to %2 %3</source>
        <translation>von %1 bis %2 %3</translation>
    </message>
    <message>
        <source>%1 · parameter of %2</source>
        <translation>%1 · Parameter von %2</translation>
    </message>
</context>
<context>
    <name>asperity::ScreenPreview</name>
    <message>
        <source>← Back</source>
        <translation>← Zurück</translation>
    </message>
    <message>
        <source>Next →</source>
        <translation>Weiter →</translation>
    </message>
    <message>
        <source>The participant&apos;s screen</source>
        <translation>Der Bildschirm der Versuchsperson</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>%1: the participant sees nothing new</source>
        <translation>%1: Die Versuchsperson sieht nichts Neues</translation>
    </message>
    <message>
        <source>%1, screen %2 of %3</source>
        <translation>%1, Bild %2 von %3</translation>
    </message>
    <message>
        <source>%1, group %2</source>
        <translation>%1, Gruppe %2</translation>
    </message>
    <message>
        <source>The plan is being made…</source>
        <translation>Der Plan wird erstellt…</translation>
    </message>
</context>
<context>
    <name>asperity::SessionControls</name>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Ends the trial with the mouse. Nothing is stored.</source>
        <translation>Beendet den Versuch mit der Maus. Nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>Do not pause</source>
        <translation>Nicht anhalten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Esc or F6</source>
        <translation>Esc oder F6</translation>
    </message>
    <message>
        <source>Do not stop</source>
        <translation>Nicht stoppen</translation>
    </message>
    <message>
        <source>Stop after trial</source>
        <translation>Nach Durchgang stoppen</translation>
    </message>
    <message>
        <source>F7</source>
        <translation>F7</translation>
    </message>
    <message>
        <source>Stop after block</source>
        <translation>Nach Block stoppen</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>Repeat last…</source>
        <translation>Letzten wiederholen…</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Strg+R</translation>
    </message>
    <message>
        <source>Skip…</source>
        <translation>Überspringen…</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Abort…</source>
        <translation>Abbrechen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Q</source>
        <translation>Strg+Umschalt+Q</translation>
    </message>
    <message>
        <source>No session is under way.</source>
        <translation>Es läuft keine Sitzung.</translation>
    </message>
    <message>
        <source>Pause: the session is already stopped.</source>
        <translation>Anhalten: Die Sitzung ist bereits gestoppt.</translation>
    </message>
    <message>
        <source>Repeat: the last trial is repeated next.</source>
        <translation>Wiederholen: Der letzte Durchgang wird als Nächstes wiederholt.</translation>
    </message>
    <message>
        <source>Repeat: no trial has been completed yet.</source>
        <translation>Wiederholen: Es ist noch kein Durchgang abgeschlossen.</translation>
    </message>
    <message>
        <source>Skip: no trial is under way.</source>
        <translation>Überspringen: Es läuft kein Durchgang.</translation>
    </message>
    <message>
        <source>Note: the keys are reserved for the response; use a phrase.</source>
        <translation>Notiz: Die Tasten sind gerade für die Antwort reserviert; einen Textbaustein verwenden.</translation>
    </message>
    <message>
        <source>Brings the participant&apos;s window back to its place, in front of the others.</source>
        <translation>Bringt das Fenster der Versuchsperson an seinen Platz zurück, vor die anderen.</translation>
    </message>
    <message>
        <source>Show participant&apos;s window</source>
        <translation>Fenster zeigen</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The preparation is being cancelled.</source>
        <translation>Die Vorbereitung wird abgebrochen.</translation>
    </message>
    <message>
        <source>The session has not begun: its files are being read and the device is being opened.</source>
        <translation>Die Sitzung hat noch nicht begonnen: Ihre Dateien werden gelesen, und das Gerät wird geöffnet.</translation>
    </message>
    <message>
        <source>Repeat: practice is being repeated, which does not count.</source>
        <translation>Wiederholen: Es wird Übung wiederholt, die nicht zählt.</translation>
    </message>
</context>
<context>
    <name>asperity::SessionDesk</name>
    <message>
        <source>A session is running. End it in its own window first.</source>
        <translation>Eine Sitzung läuft. Sie zuerst in ihrem eigenen Fenster beenden.</translation>
    </message>
    <message>
        <source>Only one session can be open at a time: close the window of the open one first.</source>
        <translation>Es kann nur eine Sitzung zugleich geöffnet sein: zuerst das Fenster der offenen schließen.</translation>
    </message>
    <message>
        <source>The window of the session that has ended is still open. Close it first.</source>
        <translation>Das Fenster der beendeten Sitzung ist noch offen. Es zuerst schließen.</translation>
    </message>
    <message>
        <source>The sessions of virtual participants are being simulated. Cancel the simulation first, or wait until it is complete.</source>
        <translation>Die Sitzungen virtueller Versuchspersonen werden simuliert. Zuerst die Simulation abbrechen, oder warten, bis sie abgeschlossen ist.</translation>
    </message>
    <message>
        <source>You try this experiment with the mouse.</source>
        <translation>Sie probieren dieses Experiment mit der Maus aus.</translation>
    </message>
    <message>
        <source>The mouse exerts no force: you will not feel the surfaces. The forces that a device would exert are computed, and the session window plots them. Where a surface is shown, keep the left mouse button pressed on it and stroke it.</source>
        <translation>Die Maus übt keine Kraft aus: Sie werden die Oberflächen nicht fühlen. Die Kräfte, die ein Gerät ausüben würde, werden berechnet und im Sitzungsfenster gezeichnet. Wo eine Oberfläche gezeigt wird, halten Sie die linke Maustaste auf ihr gedrückt und streichen Sie über sie.</translation>
    </message>
    <message>
        <source>Do not put on the eye mask when a text asks for it.</source>
        <translation>Setzen Sie die Augenbinde nicht auf, wenn ein Text darum bittet.</translation>
    </message>
    <message>
        <source>The experiment ends after two trials. They belong to a temporary copy, and nothing is stored in the study.</source>
        <translation>Das Experiment endet nach zwei Durchgängen. Sie gehören zu einer vorübergehenden Kopie; in der Studie wird nichts gespeichert.</translation>
    </message>
    <message>
        <source>A session is being prepared.</source>
        <translation>Eine Sitzung wird vorbereitet.</translation>
    </message>
    <message>
        <source>The trial with the mouse has ended. Nothing was stored in the study.</source>
        <translation>Der Versuch mit der Maus ist beendet. In der Studie wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>The trial with the mouse has ended: %1. Nothing was stored in the study.</source>
        <translation>Der Versuch mit der Maus ist beendet: %1. In der Studie wurde nichts gespeichert.</translation>
    </message>
</context>
<context>
    <name>asperity::SessionHeader</name>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Session %1 · %2 · %3 · %4</source>
        <translation>Sitzung %1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>▲ Blind again; UNBLINDED at %1</source>
        <translation>▲ Wieder verblindet; ENTBLINDET um %1</translation>
    </message>
    <message>
        <source>▲ UNBLINDED at %1</source>
        <translation>▲ ENTBLINDET um %1</translation>
    </message>
    <message>
        <source>Blind: conditions are shown as codes</source>
        <translation>Verblindet: Bedingungen als Codes</translation>
    </message>
    <message>
        <source>Names are shown</source>
        <translation>Namen werden gezeigt</translation>
    </message>
    <message>
        <source>Unblind…</source>
        <translation>Entblinden…</translation>
    </message>
    <message>
        <source>Show names</source>
        <translation>Namen zeigen</translation>
    </message>
    <message>
        <source>Blind again</source>
        <translation>Wieder verblinden</translation>
    </message>
    <message>
        <source>Hide names</source>
        <translation>Namen verbergen</translation>
    </message>
    <message>
        <source>Block %1 of %2</source>
        <translation>Block %1 von %2</translation>
    </message>
    <message>
        <source>Blocks: %1</source>
        <translation>Blöcke: %1</translation>
    </message>
    <message>
        <source>trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>trials: %1</source>
        <translation>Durchgänge: %1</translation>
    </message>
    <message>
        <source>%1 elapsed</source>
        <translation>%1 vergangen</translation>
    </message>
    <message>
        <source>■ EMERGENCY STOP</source>
        <translation>■ NOT-HALT</translation>
    </message>
    <message>
        <source>F12 from any window</source>
        <translation>F12 aus jedem Fenster</translation>
    </message>
    <message>
        <source>Sets the force to zero at once, from any window. F12, Pause/Break and Ctrl+Space do the same.</source>
        <translation>Setzt die Kraft sofort auf null, von jedem Fenster aus. F12, Pause/Untbr und Strg+Leertaste tun dasselbe.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>repeated practice, trial %1</source>
        <translation>wiederholte Übung, Durchgang %1</translation>
    </message>
</context>
<context>
    <name>asperity::SessionParts</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Force and path</source>
        <translation>Kraft und Weg</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Folgen (Tracks)</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Antworten</translation>
    </message>
</context>
<context>
    <name>asperity::SessionQuestions</name>
    <message>
        <source>Reason for repeating the last trial. Its response remains stored but no longer counts.</source>
        <translation>Grund für die Wiederholung des letzten Durchgangs. Seine Antwort bleibt gespeichert, zählt aber nicht mehr.</translation>
    </message>
    <message>
        <source>Repeat last trial</source>
        <translation>Letzten Durchgang wiederholen</translation>
    </message>
    <message>
        <source>Reason for skipping trial %1. It is stored as skipped and not presented again.</source>
        <translation>Grund für das Überspringen von Durchgang %1. Dieser wird als übersprungen gespeichert und nicht erneut dargeboten.</translation>
    </message>
    <message>
        <source>Skip this trial</source>
        <translation>Diesen Durchgang überspringen</translation>
    </message>
    <message>
        <source>Reason for unblinding. It is stored with the session, and the window stays marked.</source>
        <translation>Grund für die Entblindung. Er wird mit der Sitzung gespeichert, und das Fenster bleibt gekennzeichnet.</translation>
    </message>
    <message>
        <source>Unblind</source>
        <translation>Entblinden</translation>
    </message>
</context>
<context>
    <name>asperity::SessionRunner</name>
    <message numerus="yes">
        <source>The force is zero and the session has stopped. Every completed trial is stored (%n attempt(s) since the session was started or resumed). Fix the cause, then resume this session on the Sessions page.</source>
        <translation>
            <numerusform>Die Kraft ist null, und die Sitzung ist gestoppt. Jeder abgeschlossene Durchgang ist gespeichert (%n Versuch seit dem letzten Start der Sitzung). Die Ursache beheben, dann diese Sitzung auf der Seite „Sitzungen“ fortsetzen.</numerusform>
            <numerusform>Die Kraft ist null, und die Sitzung ist gestoppt. Jeder abgeschlossene Durchgang ist gespeichert (%n Versuche seit dem letzten Start der Sitzung). Die Ursache beheben, dann diese Sitzung auf der Seite „Sitzungen“ fortsetzen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The session did not begin and no trial was run. Fix the cause, then start it again.</source>
        <translation>Die Sitzung hat nicht begonnen, und kein Durchgang lief. Die Ursache beheben, dann erneut starten.</translation>
    </message>
    <message>
        <source>Nothing was stored in the study.</source>
        <translation>In der Studie wurde nichts gespeichert.</translation>
    </message>
</context>
<context>
    <name>asperity::SessionTroubles</name>
    <message>
        <source>EMERGENCY STOP at %1. The device was commanded to zero force; its response is awaited.</source>
        <translation>NOT-HALT um %1. Dem Gerät wurde Kraft null befohlen; seine Rückmeldung steht aus.</translation>
    </message>
    <message>
        <source>EMERGENCY STOP at %1. %2</source>
        <translation>NOT-HALT um %1. %2</translation>
    </message>
    <message>
        <source>EMERGENCY STOP at %1. The force is zero and is held at zero.</source>
        <translation>NOT-HALT um %1. Die Kraft ist null und wird auf null gehalten.</translation>
    </message>
    <message>
        <source>Stopped at %1; the force is held at zero. %2</source>
        <translation>Gestoppt um %1; die Kraft wird auf null gehalten. %2</translation>
    </message>
    <message>
        <source>Stopped at %1; the force is held at zero: %2.</source>
        <translation>Gestoppt um %1; die Kraft wird auf null gehalten: %2.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Done (F5)</source>
        <translation>Fertig (F5)</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>The screen “%1” was disconnected. Its contents are now on another screen. If it was the participant&apos;s screen, pause and reconnect it.</source>
        <translation>Der Bildschirm „%1“ wurde getrennt. Sein Inhalt ist jetzt auf einem anderen Bildschirm. Falls es der Bildschirm der Versuchsperson war, die Sitzung anhalten und ihn wieder anschließen.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>The participant&apos;s screen “%1” was disconnected: the force is zero, and the trial is repeated. Reconnect the screen, restore the window, then clear the stop.</source>
        <translation>Der Bildschirm „%1“ der Versuchsperson wurde getrennt: Die Kraft ist null, und der Durchgang wird wiederholt. Den Bildschirm wieder anschließen, das Fenster zurückholen, dann den Halt quittieren.</translation>
    </message>
    <message>
        <source>The participant&apos;s screen “%1” was disconnected. There is no force, and the session pauses before the next trial. Reconnect the screen, restore the participant&apos;s window, then resume with F5.</source>
        <translation>Der Bildschirm „%1“ der Versuchsperson wurde getrennt. Es wirkt keine Kraft, und die Sitzung hält vor dem nächsten Durchgang an. Den Bildschirm wieder anschließen, das Fenster zurückholen, dann mit F5 fortsetzen.</translation>
    </message>
    <message>
        <source>The screen “%1” is still disconnected. Until it is reconnected, the participant&apos;s window is shown on the remaining screen.</source>
        <translation>Der Bildschirm „%1“ ist noch nicht wieder angeschlossen. Bis dahin wird das Fenster der Versuchsperson auf dem verbliebenen Bildschirm gezeigt.</translation>
    </message>
    <message>
        <source>Restore window</source>
        <translation>Fenster zurückholen</translation>
    </message>
    <message>
        <source>%1  The device reports: %2</source>
        <translation>%1  Das Gerät meldet: %2</translation>
    </message>
</context>
<context>
    <name>asperity::SessionWindow</name>
    <message>
        <source>Session – Asperity</source>
        <translation>Sitzung – Asperity</translation>
    </message>
    <message>
        <source>The session has ended</source>
        <translation>Die Sitzung ist zu Ende</translation>
    </message>
    <message>
        <source>Keys reserved for the response</source>
        <translation>Tasten für die Antwort reserviert</translation>
    </message>
    <message>
        <source>%1 – Asperity</source>
        <translation>%1 – Asperity</translation>
    </message>
    <message>
        <source>Preparing the session</source>
        <translation>Sitzung wird vorbereitet</translation>
    </message>
    <message>
        <source>Paused since %1; resume with F5</source>
        <translation>Angehalten seit %1; fortsetzen mit F5</translation>
    </message>
    <message>
        <source>Resuming</source>
        <translation>Wird fortgesetzt</translation>
    </message>
    <message>
        <source>Pausing after this trial</source>
        <translation>Anhalten nach diesem Durchgang</translation>
    </message>
    <message>
        <source>Stopping after this trial</source>
        <translation>Stopp nach diesem Durchgang</translation>
    </message>
    <message>
        <source>Stopping after this block</source>
        <translation>Stopp nach diesem Block</translation>
    </message>
    <message>
        <source>Repeating the last trial next</source>
        <translation>Der letzte Durchgang wird als Nächstes wiederholt</translation>
    </message>
    <message>
        <source>Clearing the fault</source>
        <translation>Störung wird quittiert</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>Grund: %1</translation>
    </message>
    <message>
        <source>The session did not begin</source>
        <translation>Die Sitzung hat nicht begonnen</translation>
    </message>
</context>
<context>
    <name>asperity::SessionsPage</name>
    <message>
        <source>Run</source>
        <translation>Erhebung</translation>
    </message>
    <message>
        <source>Pilot</source>
        <translation>Pilot</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>running now</source>
        <translation>läuft gerade</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>No sessions yet</source>
        <translation>Noch keine Sitzungen</translation>
    </message>
    <message>
        <source>Filter: participant, protocol, state</source>
        <translation>Filter: Vp, Protokoll, Zustand</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Vp</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Begonnen</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Show trials</source>
        <translation>Durchgänge zeigen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Select a session.</source>
        <translation>Eine Sitzung auswählen.</translation>
    </message>
    <message>
        <source>The session is running, here or in another program; wait until it has ended, or stop it there.</source>
        <translation>Die Sitzung läuft, hier oder in einem anderen Programm; warten, bis sie beendet ist, oder sie dort beenden.</translation>
    </message>
    <message>
        <source>Trials completed and stored: %1 of %2.</source>
        <translation>Durchgänge abgeschlossen und gespeichert: %1 von %2.</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>%1; excluded from analyses: %2</source>
        <translation>%1; von den Auswertungen ausgeschlossen: %2</translation>
    </message>
    <message>
        <source>The session is running: until it ends, only its own window shows its data, as far as the blinding permits.</source>
        <translation>Die Sitzung läuft: Bis zum Ende der Sitzung zeigt nur ihr eigenes Fenster ihre Daten, soweit die Verblindung es zulässt.</translation>
    </message>
    <message>
        <source>This study is read-only: no session can be stored. Copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt: Es kann keine Sitzung gespeichert werden. Die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>%1 virtual</source>
        <translation>%1 virtuell</translation>
    </message>
    <message>
        <source>Choose a protocol on the Protocols page and press “Start session…”. To preview the results, press “Simulate…” there: a simulation takes minutes, a session about an hour.</source>
        <translation>Auf der Seite „Protokolle“ ein Protokoll wählen und „Sitzung starten…“ drücken. Für eine Vorschau der Ergebnisse dort „Simulieren…“ drücken: Eine Simulation dauert Minuten, eine Sitzung eine Stunde.</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>Resume this session…</source>
        <translation>Diese Sitzung fortsetzen…</translation>
    </message>
    <message>
        <source>The session is complete: there is nothing to resume.</source>
        <translation>Die Sitzung ist vollständig: Es gibt nichts fortzusetzen.</translation>
    </message>
    <message>
        <source>The session has ended as its protocol specifies: there is nothing to resume.</source>
        <translation>Die Sitzung wurde so beendet, wie ihr Protokoll es vorsieht: Es gibt nichts fortzusetzen.</translation>
    </message>
    <message>
        <source>None of the study&apos;s protocols has the text that the session began with. Restore %1 version %2 to resume.</source>
        <translation>Kein Protokoll der Studie hat noch den Text, mit dem die Sitzung begann. %1 Version %2 wiederherstellen, um die Sitzung fortzusetzen.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>%1 of about %2</source>
        <translation>%1 von etwa %2</translation>
    </message>
    <message>
        <source>Trials completed and stored: %1 of about %2.</source>
        <translation>Durchgänge abgeschlossen und gespeichert: %1 von etwa %2.</translation>
    </message>
    <message>
        <source>Trials completed and stored: %1. Further trials in the plan: %2, not needed, because the criterion of their block was reached or could no longer be.</source>
        <translation>Abgeschlossene und gespeicherte Durchgänge: %1. Weitere Durchgänge im Plan: %2, nicht benötigt, weil das Kriterium ihres Blocks erreicht oder nicht mehr erreichbar war.</translation>
    </message>
</context>
<context>
    <name>asperity::SetupCard</name>
    <message>
        <source>Device and screens</source>
        <translation>Gerät und Bildschirme</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Gehalten mit</translation>
    </message>
    <message>
        <source>The participant&apos;s window</source>
        <translation>Fenster der Versuchsperson</translation>
    </message>
    <message>
        <source>If both use one keyboard, the experimenter&apos;s text fields are disabled while a response is expected.</source>
        <translation>Bei einer gemeinsamen Tastatur sind die Textfelder der Versuchsleitung gesperrt, solange eine Antwort erwartet wird.</translation>
    </message>
    <message>
        <source>The workspace and the strokes are mirrored left to right.</source>
        <translation>Arbeitsraum und Striche sind links-rechts gespiegelt.</translation>
    </message>
    <message>
        <source>The workspace as the protocol describes it.</source>
        <translation>Der Arbeitsraum, wie das Protokoll ihn beschreibt.</translation>
    </message>
    <message>
        <source>Full screen on %1 (%2 × %3)</source>
        <translation>Vollbild auf %1 (%2 × %3)</translation>
    </message>
    <message>
        <source>The same hand as when the session began.</source>
        <translation>Dieselbe Hand wie zu Beginn der Sitzung.</translation>
    </message>
    <message>
        <source>The participant has a separate keyboard or device buttons</source>
        <translation>Die Versuchsperson hat eine eigene Tastatur oder Gerätetasten</translation>
    </message>
    <message>
        <source>Next to this window</source>
        <translation>Neben diesem Fenster</translation>
    </message>
</context>
<context>
    <name>asperity::ShareStudyDialog</name>
    <message>
        <source>Share the study</source>
        <translation>Studie freigeben</translation>
    </message>
    <message>
        <source>Members of the group can read and change everything in %1 and run sessions. Other users of this computer cannot read it.</source>
        <translation>Mitglieder der Gruppe können alles in %1 lesen und ändern und Sitzungen durchführen. Andere Benutzer dieses Rechners können es nicht lesen.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>At present the study is shared with the group “%1”.</source>
        <translation>Derzeit ist die Studie für die Gruppe „%1“ freigegeben.</translation>
    </message>
    <message>
        <source>At present every user of this computer can read the study.</source>
        <translation>Derzeit kann jeder Benutzer dieses Rechners die Studie lesen.</translation>
    </message>
    <message>
        <source>At present the study is not shared.</source>
        <translation>Derzeit ist die Studie nicht freigegeben.</translation>
    </message>
</context>
<context>
    <name>asperity::ShownText</name>
    <message>
        <source>today %1</source>
        <translation>heute %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>gestern %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>hand and screen visible</source>
        <translation>Hand und Bildschirm sichtbar</translation>
    </message>
    <message>
        <source>hand hidden, screen visible</source>
        <translation>Hand verdeckt, Bildschirm sichtbar</translation>
    </message>
    <message>
        <source>blindfold</source>
        <translation>Augenbinde</translation>
    </message>
    <message>
        <source>no masking noise</source>
        <translation>kein Maskierrauschen</translation>
    </message>
    <message>
        <source>pink masking noise</source>
        <translation>rosa Maskierrauschen</translation>
    </message>
    <message>
        <source>white masking noise</source>
        <translation>weißes Maskierrauschen</translation>
    </message>
    <message>
        <source>pink masking noise, %1 dB(A)</source>
        <translation>rosa Maskierrauschen, %1 dB(A)</translation>
    </message>
    <message>
        <source>white masking noise, %1 dB(A)</source>
        <translation>weißes Maskierrauschen, %1 dB(A)</translation>
    </message>
    <message>
        <source>simulated clock</source>
        <translation>simulierte Uhr</translation>
    </message>
</context>
<context>
    <name>asperity::StartPage</name>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weiteres.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
    </message>
    <message>
        <source>Start a session</source>
        <translation>Sitzung starten</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>Maskierrauschen</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Erhebung</translation>
    </message>
    <message>
        <source>Pilot</source>
        <translation>Pilot</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Virtual participants</source>
        <translation>Virtuelle Versuchspersonen</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>So schnell wie möglich</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Start session</source>
        <translation>Sitzung starten</translation>
    </message>
    <message>
        <source>This protocol is not valid. %1.</source>
        <translation>Dieses Protokoll ist nicht gültig. %1.</translation>
    </message>
    <message>
        <source>The study has no protocol yet: create one on the Protocols page.</source>
        <translation>Die Studie hat noch kein Protokoll: auf der Seite „Protokolle“ eines anlegen.</translation>
    </message>
    <message>
        <source>Choose a protocol.</source>
        <translation>Ein Protokoll wählen.</translation>
    </message>
    <message>
        <source>%1 · version %2 · SHA-256 %3</source>
        <translation>%1 · Version %2 · SHA-256 %3</translation>
    </message>
    <message>
        <source>1 trial</source>
        <translation>1 Durchgang</translation>
    </message>
    <message numerus="yes">
        <source>%n trials</source>
        <translation>
            <numerusform>%n Durchgang</numerusform>
            <numerusform>%n Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, about %2 · %3 · %4</source>
        <translation>%1, etwa %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Study data. Plan and plots show codes in place of names.</source>
        <translation>Studiendaten. Plan und Kurven zeigen Codes statt Namen.</translation>
    </message>
    <message>
        <source>A test of the experiment with a participant. Stored separately from the study data.</source>
        <translation>Ein Test des Experiments mit einer Versuchsperson. Getrennt von den Studiendaten gespeichert.</translation>
    </message>
    <message>
        <source>Virtual participants test the study. Their responses are not data about human perception.</source>
        <translation>Virtuelle Versuchspersonen testen die Studie. Ihre Antworten sind keine Daten über die Wahrnehmung von Menschen.</translation>
    </message>
    <message>
        <source>In real time, only one virtual participant can be simulated at a time.</source>
        <translation>In Echtzeit kann jeweils nur eine virtuelle Versuchsperson simuliert werden.</translation>
    </message>
    <message>
        <source>One session, shown while it runs.</source>
        <translation>Eine Sitzung, die während des Ablaufs gezeigt wird.</translation>
    </message>
    <message>
        <source>All sessions, run in the background.</source>
        <translation>Alle Sitzungen, im Hintergrund.</translation>
    </message>
    <message>
        <source>The program assigns the labels of virtual participants; the next one is %1.</source>
        <translation>Das Programm vergibt die Kürzel virtueller Versuchspersonen; das nächste ist %1.</translation>
    </message>
    <message numerus="yes">
        <source>The program assigns the labels of virtual participants; the first of the next %n is %1.</source>
        <translation>
            <numerusform>Das Programm vergibt die Kürzel virtueller Versuchspersonen; das nächste (%n) ist %1.</numerusform>
            <numerusform>Das Programm vergibt die Kürzel virtueller Versuchspersonen; das erste der nächsten %n ist %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Session %1 of this participant; sessions of this protocol completed: %2 of %3.</source>
        <translation>Sitzung %1 dieser Versuchsperson; abgeschlossene Sitzungen dieses Protokolls: %2 von %3.</translation>
    </message>
    <message>
        <source>%1 No counterbalancing.</source>
        <translation>%1 Keine Ausbalancierung.</translation>
    </message>
    <message>
        <source>%1 Counterbalancing row of the participant&apos;s place among those dealt to this study.</source>
        <translation>%1 Zeile der Ausbalancierung: die des Platzes der Versuchsperson unter denen, die dieser Studie zugeteilt sind.</translation>
    </message>
    <message>
        <source>%1 Counterbalancing row %2 of %3, the least used one.</source>
        <translation>%1 Zeile %2 von %3 der Ausbalancierung, die bisher am seltensten verwendete.</translation>
    </message>
    <message numerus="yes">
        <source>Simulate %n participants</source>
        <translation>
            <numerusform>%n Versuchsperson simulieren</numerusform>
            <numerusform>%n Versuchspersonen simulieren</numerusform>
        </translation>
    </message>
    <message>
        <source>The sessions of virtual participants are being simulated.</source>
        <translation>Die Sitzungen virtueller Versuchspersonen werden simuliert.</translation>
    </message>
    <message>
        <source>Ready.</source>
        <translation>Bereit.</translation>
    </message>
    <message>
        <source>No protocol is chosen; choose one.</source>
        <translation>Es ist kein Protokoll gewählt; eines wählen.</translation>
    </message>
    <message>
        <source>The protocol is not valid; correct it, or choose another one.</source>
        <translation>Das Protokoll ist nicht gültig; es korrigieren oder ein anderes wählen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The study could not be read: %1</source>
        <translation>Die Studie konnte nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>The study is being read.</source>
        <translation>Die Studie wird gelesen.</translation>
    </message>
    <message>
        <source>The study has not been read; press “Try again”.</source>
        <translation>Die Studie wurde noch nicht gelesen; „Erneut versuchen“ drücken.</translation>
    </message>
    <message>
        <source>A device is being tried: wait for the result.</source>
        <translation>Ein Gerät wird ausprobiert: das Ergebnis abwarten.</translation>
    </message>
    <message>
        <source>The checks were cancelled: press “Check again”.</source>
        <translation>Die Prüfungen wurden abgebrochen: „Erneut prüfen“ drücken.</translation>
    </message>
    <message>
        <source>Running the checks…</source>
        <translation>Die Prüfungen laufen…</translation>
    </message>
    <message>
        <source>The session of %1 cannot be resumed with this protocol: its text has changed since the session began. To resume it, restore the earlier text; a session started here is a new one.</source>
        <translation>Die Sitzung von %1 kann mit diesem Protokoll nicht fortgesetzt werden: Sein Text hat sich seit Beginn der Sitzung geändert. Zum Fortsetzen den früheren Text wiederherstellen; eine hier gestartete Sitzung ist eine neue.</translation>
    </message>
    <message>
        <source>A session is resumed in the mode in which it began.</source>
        <translation>Eine Sitzung wird in dem Modus fortgesetzt, in dem sie begann.</translation>
    </message>
    <message>
        <source>A simulated session is resumed at the speed at which it began.</source>
        <translation>Eine simulierte Sitzung wird in dem Tempo fortgesetzt, in dem sie begann.</translation>
    </message>
    <message>
        <source>Resume a session</source>
        <translation>Sitzung fortsetzen</translation>
    </message>
    <message>
        <source>Resume session %1</source>
        <translation>Sitzung %1 fortsetzen</translation>
    </message>
    <message>
        <source>%1 Group %2, as before.</source>
        <translation>%1 Gruppe %2, wie bisher.</translation>
    </message>
    <message>
        <source>%1 The program assigns the group.</source>
        <translation>%1 Das Programm teilt die Gruppe zu.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>The stimuli are being examined; the session does not wait for this.</source>
        <translation>Die Reize werden untersucht; die Sitzung wartet nicht darauf.</translation>
    </message>
    <message>
        <source>Language of the participant</source>
        <translation>Sprache der Versuchsperson</translation>
    </message>
    <message>
        <source>The participant keeps the language of the earlier sessions.</source>
        <translation>Die Versuchsperson behält die Sprache der früheren Sitzungen.</translation>
    </message>
    <message>
        <source>The earlier sessions of this participant were in the language “%1”: add this translation of the protocol, or choose another participant.</source>
        <translation>Die früheren Sitzungen dieser Versuchsperson waren in der Sprache „%1“: diese Übersetzung des Protokolls hinzufügen oder eine andere Versuchsperson wählen.</translation>
    </message>
    <message>
        <source>A terminal has no mouse: choose another device.</source>
        <translation>Ein Terminal hat keine Maus: ein anderes Gerät wählen.</translation>
    </message>
    <message>
        <source>A terminal does not mirror the workspace for a left hand.</source>
        <translation>Ein Terminal spiegelt den Arbeitsraum nicht für eine linke Hand.</translation>
    </message>
    <message>
        <source>The terminal asks for the consent, the details of a new participant and all responses.</source>
        <translation>Das Terminal fragt nach der Einwilligung, den Angaben einer neuen Versuchsperson und allen Antworten.</translation>
    </message>
</context>
<context>
    <name>asperity::StimuliPage</name>
    <message>
        <source>Stimuli</source>
        <translation>Reize</translation>
    </message>
    <message>
        <source>No stimuli yet</source>
        <translation>Noch keine Reize</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Pitch, µm</source>
        <translation>Raster, µm</translation>
    </message>
    <message>
        <source>RMS, µm</source>
        <translation>RMS, µm</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Verwendet von</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>height field (%1)</source>
        <translation>Höhenfeld (%1)</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>no protocol</source>
        <translation>keinem Protokoll</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>mesh of %1 triangles</source>
        <translation>Netz aus %1 Dreiecken</translation>
    </message>
    <message>
        <source>%1 of %2 triangles</source>
        <translation>%1 aus %2 Dreiecken</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Made from %1.</source>
        <translation>Erzeugt aus %1.</translation>
    </message>
    <message>
        <source>data file</source>
        <translation>Datendatei</translation>
    </message>
    <message>
        <source>rendering (%1)</source>
        <translation>Wiedergabe (%1)</translation>
    </message>
    <message>
        <source>Stimuli are pictures, height fields and textured meshes in the study&apos;s folder “stimuli”, and the bodies of its protocols. Make one from a photograph on the Workbench page, compute one, or copy files into the folder: they appear here at once.</source>
        <translation>Reize sind Bilder, Höhenfelder und texturierte Netze im Ordner „stimuli“ der Studie und die Körper ihrer Protokolle. Auf der Seite „Werkstatt“ einen Reiz aus einem Foto erzeugen, einen berechnen oder Dateien in den Ordner kopieren: Sie erscheinen hier sofort.</translation>
    </message>
    <message>
        <source>Compute a texture…</source>
        <translation>Textur berechnen…</translation>
    </message>
    <message>
        <source>Copy from another study…</source>
        <translation>Aus einer anderen Studie kopieren…</translation>
    </message>
    <message>
        <source>A grating, noise, cones or another surface with known heights</source>
        <translation>Ein Gitter, Rauschen, Kegel oder eine andere Oberfläche mit bekannten Höhen</translation>
    </message>
    <message numerus="yes">
        <source>%n stimuli were copied.</source>
        <translation>
            <numerusform>%n Reiz wurde kopiert.</numerusform>
            <numerusform>%n Reize wurden kopiert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>asperity::StimulusActions</name>
    <message>
        <source>Open in the workbench</source>
        <translation>In der Werkstatt öffnen</translation>
    </message>
    <message>
        <source>Use in an experiment…</source>
        <translation>In einem Experiment verwenden…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose a stimulus to open, rename or delete it.</source>
        <translation>Einen Reiz wählen, um ihn zu öffnen, umzubenennen oder zu löschen.</translation>
    </message>
    <message>
        <source>This body is part of a protocol: change it there.</source>
        <translation>Dieser Körper ist Teil eines Protokolls: dort ändern.</translation>
    </message>
    <message>
        <source>This study is read-only; copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt; die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>The workbench opens pictures, height fields and renderings.</source>
        <translation>Die Werkstatt öffnet Bilder, Höhenfelder und Wiedergaben.</translation>
    </message>
    <message>
        <source>New name of %1 (without its ending).</source>
        <translation>Neuer Name von %1 (ohne die Endung).</translation>
    </message>
    <message>
        <source>Renamed with it: %1.</source>
        <translation>Mit umbenannt wird: %1.</translation>
    </message>
    <message>
        <source>The references are changed in: %1.</source>
        <translation>Die Verweise werden geändert in: %1.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete %1? Protocols with its values keep them. The file cannot be restored.</source>
        <translation>%1 löschen? Protokolle mit den Werten behalten sie. Die Datei ist nicht wiederherstellbar.</translation>
    </message>
    <message>
        <source>Delete %1? Nothing refers to it. The files cannot be restored.</source>
        <translation>%1 löschen? Nichts bezieht sich darauf. Die Dateien sind nicht wiederherstellbar.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>No reference is changed.</source>
        <translation>Kein Verweis wird geändert.</translation>
    </message>
    <message>
        <source>Protocols with sessions keep the present name: %1.</source>
        <translation>Protokolle mit Sitzungen behalten den jetzigen Namen: %1.</translation>
    </message>
    <message>
        <source>It is the photograph of %1, which has none under another name.</source>
        <translation>Das Bild ist das Foto von %1; unter einem anderen Namen fehlt es dort.</translation>
    </message>
    <message>
        <source>Delete %1? It is the photograph of %2. The file cannot be restored.</source>
        <translation>%1 löschen? Das Bild ist das Foto von %2. Die Datei ist nicht wiederherstellbar.</translation>
    </message>
</context>
<context>
    <name>asperity::StudyPage</name>
    <message>
        <source>The study could not be read: %1</source>
        <translation>Die Studie konnte nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
</context>
<context>
    <name>asperity::StudyWindow</name>
    <message>
        <source>Protocols</source>
        <translation>Protokolle</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Versuchspersonen</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Stimuli</source>
        <translation>Reize</translation>
    </message>
    <message>
        <source>Workbench</source>
        <translation>Werkstatt</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Asperity</source>
        <translation>Asperity</translation>
    </message>
    <message>
        <source>%1 – Asperity</source>
        <translation>%1 – Asperity</translation>
    </message>
    <message>
        <source>%1 is an empty folder and not yet a study. It can become one.</source>
        <translation>%1 ist ein leerer Ordner und noch keine Studie. Er kann eine werden.</translation>
    </message>
    <message>
        <source>Create here</source>
        <translation>Hier anlegen</translation>
    </message>
    <message>
        <source>The study could not be opened: %1</source>
        <translation>Die Studie konnte nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>The study is no longer at %1: its folder was removed or renamed, or is on a disk that is no longer connected. Restore the folder, or close the study.</source>
        <translation>Die Studie ist nicht mehr bei %1: Ihr Ordner wurde entfernt oder umbenannt oder liegt auf einem Datenträger, der nicht mehr angeschlossen ist. Den Ordner wiederherstellen oder die Studie schließen.</translation>
    </message>
    <message>
        <source>Close study</source>
        <translation>Studie schließen</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>&amp;Studie</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>&amp;Neu…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open the &amp;demo study</source>
        <translation>&amp;Demostudie öffnen</translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation>&amp;Zuletzt benutzt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>No study has been opened yet</source>
        <translation>Es wurde noch keine Studie geöffnet</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Use &amp;system setting</source>
        <translation>S&amp;ystemeinstellung verwenden</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>L&amp;anguage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Documents</source>
        <translation>&amp;Dokumente</translation>
    </message>
    <message>
        <source>&amp;About Asperity</source>
        <translation>&amp;Über Asperity</translation>
    </message>
    <message>
        <source>The study could not be created: %1</source>
        <translation>Die Studie konnte nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>Open the folder of a study</source>
        <translation>Ordner einer Studie öffnen</translation>
    </message>
    <message>
        <source>S&amp;hare…</source>
        <translation>Fr&amp;eigeben…</translation>
    </message>
    <message>
        <source>The study is shared with the group %1, but its members cannot access it: they have no permission for the folder %2. Give the group access to that folder, or move the study out of it.</source>
        <translation>Die Studie ist für die Gruppe %1 freigegeben, aber deren Mitglieder haben keinen Zugriff: Für den Ordner %2 fehlt ihnen die Berechtigung. Der Gruppe Zugriff auf diesen Ordner geben oder die Studie verschieben.</translation>
    </message>
    <message>
        <source>The study is shared with the group %1. Other users cannot read it.</source>
        <translation>Die Studie ist für die Gruppe %1 freigegeben. Andere Benutzer können sie nicht lesen.</translation>
    </message>
    <message>
        <source>The study could not be shared: %1</source>
        <translation>Die Studie konnte nicht freigegeben werden: %1</translation>
    </message>
    <message>
        <source>&amp;Metadata…</source>
        <translation>&amp;Metadaten…</translation>
    </message>
    <message>
        <source>The metadata of the study have been stored.</source>
        <translation>Die Metadaten der Studie wurden gespeichert.</translation>
    </message>
    <message>
        <source>The metadata could not be stored: %1</source>
        <translation>Die Metadaten der Studie konnten nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>This study is read-only: its folder or its disk cannot be written to. It can be viewed, analysed and exported; to run sessions, copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt: In ihren Ordner oder auf den Datenträger kann nicht geschrieben werden. Sie kann angesehen, ausgewertet und exportiert werden; für Sitzungen in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>A plug-in was not loaded (Study → Plug-ins…): %1</source>
        <translation>Ein Plug-in wurde nicht geladen (Studie → Plug-ins…): %1</translation>
    </message>
    <message>
        <source>&amp;Plug-ins…</source>
        <translation>&amp;Plug-ins…</translation>
    </message>
    <message>
        <source>The plug-ins are unchanged, because loading them was cancelled.</source>
        <translation>Die Plug-ins sind unverändert, weil das Laden abgebrochen wurde.</translation>
    </message>
    <message>
        <source>The study was not opened, because loading the plug-ins was cancelled. Open it again, or remove plug-ins (Study → Plug-ins…).</source>
        <translation>Die Studie wurde nicht geöffnet, weil das Laden der Plug-ins abgebrochen wurde. Öffnen Sie sie erneut, oder entfernen Sie Plug-ins (Studie → Plug-ins…).</translation>
    </message>
    <message>
        <source>The relief in the workbench is not saved and would be lost.</source>
        <translation>Das Relief in der Werkstatt ist nicht gespeichert und ginge verloren.</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>The values of “%1” were copied. Save the protocol to keep them; Undo takes them back.</source>
        <translation>Die Werte von „%1“ wurden kopiert. Zum Behalten das Protokoll speichern; Rückgängig nimmt sie zurück.</translation>
    </message>
</context>
<context>
    <name>asperity::SurfaceCard</name>
    <message>
        <source>&lt;b&gt;Surface and hand&lt;/b&gt;, the same for all</source>
        <translation>&lt;b&gt;Oberfläche und Hand&lt;/b&gt;, für alle gleich</translation>
    </message>
    <message>
        <source>Choose a textured mesh</source>
        <translation>Netz mit Textur wählen</translation>
    </message>
    <message>
        <source>Textured meshes (*.mesh)</source>
        <translation>Netze mit Textur (*.mesh)</translation>
    </message>
    <message>
        <source>Choose mesh…</source>
        <translation>Netz wählen …</translation>
    </message>
</context>
<context>
    <name>asperity::SurfaceDialog</name>
    <message>
        <source>Compute a texture</source>
        <translation>Textur berechnen</translation>
    </message>
    <message>
        <source>Compute a texture with known heights</source>
        <translation>Textur mit bekannten Höhen berechnen</translation>
    </message>
    <message>
        <source>Name in the study</source>
        <translation>Name in der Studie</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save to study</source>
        <translation>In Studie speichern</translation>
    </message>
    <message>
        <source>Kind of surface</source>
        <translation>Art der Oberfläche</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Heights are exaggerated by a factor of %1.</source>
        <translation>Höhen sind %1-fach überhöht gezeichnet.</translation>
    </message>
    <message>
        <source>Heights are drawn to scale.</source>
        <translation>Höhen sind maßstäblich gezeichnet.</translation>
    </message>
    <message>
        <source>Enter a name for the texture.</source>
        <translation>Einen Namen für die Textur eingeben.</translation>
    </message>
    <message>
        <source>The study already has a stimulus “%1”. Choose another name.</source>
        <translation>Die Studie hat bereits einen Reiz „%1“. Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>Will be saved as %1, with its sidecar.</source>
        <translation>Wird mit Begleitdatei gespeichert als %1.</translation>
    </message>
    <message>
        <source>Compute the texture</source>
        <translation>Die Textur berechnen</translation>
    </message>
    <message>
        <source>Use at most %1 unaccented letters, digits, _ and -.</source>
        <translation>Höchstens %1 Buchstaben ohne Akzente, Ziffern, _ und - verwenden.</translation>
    </message>
    <message>
        <source>%1 mm along %2 contain %3 spacings, of %4 mm at this angle.</source>
        <translation>%1 mm entlang %2 enthalten %3 Abstände, bei diesem Winkel von %4 mm.</translation>
    </message>
    <message>
        <source>%1 mm along %2 contain %3 bricks of %4 mm.</source>
        <translation>%1 mm entlang %2 enthalten %3 Ziegel von %4 mm.</translation>
    </message>
    <message>
        <source>%1 mm along %2 contain %3 pairs of courses of %4 mm.</source>
        <translation>%1 mm entlang %2 enthalten %3 Schichtpaare von %4 mm.</translation>
    </message>
    <message>
        <source>%1 mm along %2 contain %3 spacings of %4 mm.</source>
        <translation>%1 mm entlang %2 enthalten %3 Abstände von %4 mm.</translation>
    </message>
    <message>
        <source>Choose a width of %1 mm or %2 mm.</source>
        <translation>Eine Breite von %1 mm oder %2 mm wählen.</translation>
    </message>
    <message>
        <source>Choose a width of %1 mm.</source>
        <translation>Eine Breite von %1 mm wählen.</translation>
    </message>
    <message>
        <source>Where the surface is repeated, the last one is cut, which makes an unintended step.</source>
        <translation>Wo sich die Oberfläche wiederholt, wird das letzte Stück abgeschnitten, und es entsteht eine unbeabsichtigte Stufe.</translation>
    </message>
    <message>
        <source>The samples are %1 mm apart, %2 per spacing of %3 mm: heights and shape differ from those requested. Choose at least %4 samples per side.</source>
        <translation>Die Abtastwerte liegen %1 mm auseinander, %2 je Abstand von %3 mm: Höhen und Form weichen von den gewünschten ab. Mindestens %4 Abtastwerte je Seite wählen.</translation>
    </message>
</context>
<context>
    <name>asperity::TaskLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
</context>
<context>
    <name>asperity::TemplateDialog</name>
    <message>
        <source>New protocol from a template</source>
        <translation>Neues Protokoll aus einer Vorlage</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>The templates are being read.</source>
        <translation>Die Vorlagen werden gelesen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Create protocol</source>
        <translation>Protokoll erstellen</translation>
    </message>
    <message>
        <source>The templates could not be read: %1</source>
        <translation>Die Vorlagen konnten nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Language of the participants’ texts</source>
        <translation>Sprache der Texte für Versuchspersonen</translation>
    </message>
    <message>
        <source>Textures of this study, in this order:</source>
        <translation>Texturen der Studie, in dieser Reihenfolge:</translation>
    </message>
    <message>
        <source>Textures of this study</source>
        <translation>Texturen dieser Studie</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n Durchgang</numerusform>
            <numerusform>%n Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message numerus="yes">
        <source>This template compares %n texture(s).</source>
        <translation>
            <numerusform>Diese Vorlage vergleicht %n Textur.</numerusform>
            <numerusform>Diese Vorlage vergleicht %n Texturen.</numerusform>
        </translation>
    </message>
    <message>
        <source>These textures are photographs that are not part of Asperity.</source>
        <translation>Diese Texturen sind Fotos, die nicht zu Asperity gehören.</translation>
    </message>
    <message>
        <source>Choose a template.</source>
        <translation>Eine Vorlage wählen.</translation>
    </message>
    <message>
        <source>Choose at least one texture.</source>
        <translation>Mindestens eine Textur wählen.</translation>
    </message>
    <message>
        <source>The textures are written into the study. The protocol can be changed afterwards.</source>
        <translation>Die Texturen werden in die Studie geschrieben. Das Protokoll kann danach geändert werden.</translation>
    </message>
    <message>
        <source>Check that the title is true of these textures. The description, which is about those of the template, is not copied.</source>
        <translation>Prüfen Sie, ob der Titel auf diese Texturen zutrifft. Die Beschreibung, die von denen der Vorlage handelt, wird nicht kopiert.</translation>
    </message>
    <message>
        <source>The protocol can be changed afterwards.</source>
        <translation>Das Protokoll kann danach geändert werden.</translation>
    </message>
    <message>
        <source>Write a title.</source>
        <translation>Geben Sie einen Titel ein.</translation>
    </message>
    <message>
        <source>Textures of the template</source>
        <translation>Texturen der Vorlage</translation>
    </message>
    <message>
        <source>Make textures in the workbench first: this template needs photographs or reliefs of the study.</source>
        <translation>Zuerst in der Werkstatt Texturen herstellen: Diese Vorlage braucht Fotos oder Reliefs der Studie.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
    <message>
        <source>With these textures no protocol can be created: %1</source>
        <translation>Mit diesen Texturen lässt sich kein Protokoll erstellen: %1</translation>
    </message>
    <message>
        <source>With these textures the protocol is valid.</source>
        <translation>Mit diesen Texturen ist das Protokoll gültig.</translation>
    </message>
    <message>
        <source>With these textures the protocol has a problem: %1</source>
        <translation>Mit diesen Texturen hat das Protokoll ein Problem: %1</translation>
    </message>
    <message>
        <source>With these textures the protocol has %1 problems, the first: %2</source>
        <translation>Mit diesen Texturen hat das Protokoll %1 Probleme, das erste: %2</translation>
    </message>
    <message>
        <source>The textures are being checked.</source>
        <translation>Die Texturen werden geprüft.</translation>
    </message>
    <message>
        <source>Choose other textures.</source>
        <translation>Andere Texturen wählen.</translation>
    </message>
</context>
<context>
    <name>asperity::TextCard</name>
    <message>
        <source>Show in the text</source>
        <translation>Im Text zeigen</translation>
    </message>
    <message>
        <source>%1: defined in the text</source>
        <translation>%1: im Text definiert</translation>
    </message>
</context>
<context>
    <name>asperity::TimePlots</name>
    <message>
        <source>Wheel, + or −: zoom; drag, ← or →: move; Home: show all.</source>
        <translation>Mausrad, + oder −: zoomen; ziehen, ← oder →: verschieben; Pos1: alles zeigen.</translation>
    </message>
    <message>
        <source>Force, penetration, speed and position over time</source>
        <translation>Kraft, Eindringtiefe, Geschwindigkeit und Position über der Zeit</translation>
    </message>
    <message>
        <source>NORMAL FORCE N</source>
        <translation>NORMALKRAFT N</translation>
    </message>
    <message>
        <source>rendered</source>
        <translation>berechnet</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>PENETRATION mm</source>
        <translation>EINDRINGTIEFE mm</translation>
    </message>
    <message>
        <source>SPEED mm/s, along the surface</source>
        <translation>GESCHWINDIGKEIT mm/s, längs der Oberfläche</translation>
    </message>
    <message>
        <source>POSITION mm</source>
        <translation>POSITION mm</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z, up</source>
        <translation>z, nach oben</translation>
    </message>
    <message>
        <source>time since the attempt began, s</source>
        <translation>Zeit seit Beginn des Versuchs, s</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>vorgegeben</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>in Kontakt</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 verpasst</translation>
    </message>
    <message>
        <source>%1 limited</source>
        <translation>%1 begrenzt</translation>
    </message>
</context>
<context>
    <name>asperity::TrackPanel</name>
    <message>
        <source>Tracks are hidden while you are blind to the conditions.</source>
        <translation>Folgen (Tracks) sind verborgen, solange Sie gegenüber den Bedingungen verblindet sind.</translation>
    </message>
    <message>
        <source>No response of a track yet</source>
        <translation>Noch keine Antwort einer Folge (Track)</translation>
    </message>
    <message>
        <source>This block has no tracks.</source>
        <translation>Dieser Block hat keine Folgen (Tracks).</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>Folge %1</translation>
    </message>
    <message>
        <source>Track %1 (%2)</source>
        <translation>Folge %1 (%2)</translation>
    </message>
    <message>
        <source>Filled marks lead to a lower level, hollow ones to a higher level; hollow marks with a dot: “cannot tell”.</source>
        <translation>Gefüllte Zeichen führen zu einer niedrigeren Stufe, leere zu einer höheren; leere mit Punkt: „kann es nicht sagen“.</translation>
    </message>
    <message>
        <source>%1: no estimate yet</source>
        <translation>%1: noch keine Schätzung</translation>
    </message>
    <message>
        <source>%1: posterior median %2, 95 % interval %3 to %4</source>
        <translation>%1: Median der A-posteriori-Verteilung %2, 95-%-Intervall %3 bis %4</translation>
    </message>
    <message>
        <source>trial of the track, 1 to %1</source>
        <translation>Durchgang der Folge, 1 bis %1</translation>
    </message>
    <message>
        <source>%1: mean of the reversals %2 (n = %3)</source>
        <translation>%1: Mittelwert der Umkehrpunkte %2 (n = %3)</translation>
    </message>
</context>
<context>
    <name>asperity::TrialsPage</name>
    <message>
        <source>pending</source>
        <translation>ausstehend</translation>
    </message>
    <message>
        <source>not valid: %1</source>
        <translation>nicht gültig: %1</translation>
    </message>
    <message>
        <source>flagged: %1</source>
        <translation>markiert: %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>← All sessions</source>
        <translation>← Alle Sitzungen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Began</source>
        <translation>Begann</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Notes and events</source>
        <translation>Notizen und Ereignisse</translation>
    </message>
    <message>
        <source>Trial %1, attempt %2: %3</source>
        <translation>Durchgang %1, Versuch %2: %3</translation>
    </message>
    <message>
        <source>Session %1 of %2</source>
        <translation>Sitzung %1 von %2</translation>
    </message>
    <message>
        <source>Notes and events (%1)</source>
        <translation>Notizen und Ereignisse (%1)</translation>
    </message>
    <message>
        <source>excluded: %1</source>
        <translation>ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>Show attempt</source>
        <translation>Versuch zeigen</translation>
    </message>
    <message>
        <source>Exclude session…</source>
        <translation>Sitzung ausschließen…</translation>
    </message>
    <message>
        <source>To show details, select a trial that has begun.</source>
        <translation>Einen begonnenen Durchgang auswählen, um seine Einzelheiten zu sehen.</translation>
    </message>
    <message>
        <source>Reason for including the session in the analyses again</source>
        <translation>Grund für den Wiedereinschluss der Sitzung in die Auswertungen</translation>
    </message>
    <message>
        <source>Include session</source>
        <translation>Sitzung einschließen</translation>
    </message>
    <message>
        <source>Reason for excluding the whole session from the analyses. It remains in the study and can be included again.</source>
        <translation>Grund für den Ausschluss der ganzen Sitzung von den Auswertungen. Sie bleibt in der Studie und kann wieder eingeschlossen werden.</translation>
    </message>
    <message>
        <source>Exclude session</source>
        <translation>Sitzung ausschließen</translation>
    </message>
    <message>
        <source>The whole session is excluded from analyses: %1</source>
        <translation>Die ganze Sitzung ist von den Auswertungen ausgeschlossen: %1</translation>
    </message>
    <message>
        <source>Include session again…</source>
        <translation>Sitzung wieder einschließen…</translation>
    </message>
    <message>
        <source>block %1</source>
        <translation>Block %1</translation>
    </message>
    <message>
        <source>This study is read-only; copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt; die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>Stimuli and responses are shown once the session has ended.</source>
        <translation>Reize und Antworten werden gezeigt, sobald die Sitzung beendet ist.</translation>
    </message>
    <message>
        <source>on a simulated clock</source>
        <translation>mit simulierter Uhr</translation>
    </message>
    <message>
        <source>started %1</source>
        <translation>begonnen %1</translation>
    </message>
    <message>
        <source>The session is running, and its experimenter is blind: until it ends, only its own window shows its data, as far as the blinding permits.</source>
        <translation>Die Sitzung läuft, und ihre Versuchsleitung ist verblindet: Bis zum Ende der Sitzung zeigt nur ihr eigenes Fenster ihre Daten, soweit die Verblindung es zulässt.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Parts of the session</source>
        <translation>Teile der Sitzung</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Wortlaut</translation>
    </message>
    <message>
        <source>repeated practice</source>
        <translation>wiederholte Übung</translation>
    </message>
    <message>
        <source>catch trial</source>
        <translation>Kontrolldurchgang</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, Schritt %2</translation>
    </message>
    <message>
        <source>Track %1 of the procedure, trial %2 of the track</source>
        <translation>Folge (Track) %1 des Verfahrens, Durchgang %2 der Folge</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Folge (Track)</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>nicht benötigt</translation>
    </message>
    <message>
        <source>%1 (%2 not needed)</source>
        <translation>%1 (%2 nicht benötigt)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · trials: %4 in %5 · %6 · device %7 · asperity %8</source>
        <translation>%1 %2 · %3 · Durchgänge: %4 in %5 · %6 · Gerät %7 · asperity %8</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>Anker</translation>
    </message>
</context>
<context>
    <name>asperity::UseRenderingDialog</name>
    <message>
        <source>Use a rendering in an experiment</source>
        <translation>Eine Wiedergabe in einem Experiment verwenden</translation>
    </message>
    <message>
        <source>The values are copied: the protocol does not depend on the rendering.</source>
        <translation>Die Werte werden kopiert: Das Protokoll hängt nicht von der Wiedergabe ab.</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>New from a template…</source>
        <translation>Neu aus einer Vorlage…</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Change in the editor</source>
        <translation>Im Editor ändern</translation>
    </message>
    <message>
        <source>The editor shows the changed protocol. It is stored when you save it there.</source>
        <translation>Der Editor zeigt das geänderte Protokoll. Gespeichert wird es erst dort.</translation>
    </message>
    <message>
        <source>The protocol could not be created: %1</source>
        <translation>Das Protokoll konnte nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>Replace “%1”</source>
        <translation>„%1“ ersetzen</translation>
    </message>
    <message>
        <source>Add a surface</source>
        <translation>Eine Oberfläche hinzufügen</translation>
    </message>
    <message>
        <source>Keep its textures, the levels of “%1”</source>
        <translation>Ihre Texturen behalten, die Stufen von „%1“</translation>
    </message>
    <message>
        <source>Keep its texture</source>
        <translation>Ihre Textur behalten</translation>
    </message>
    <message>
        <source>The study has no protocol yet. Create one from a template.</source>
        <translation>Die Studie hat noch kein Protokoll. Eines aus einer Vorlage anlegen.</translation>
    </message>
    <message>
        <source>This protocol cannot be read. Choose another one.</source>
        <translation>Dieses Protokoll ist nicht lesbar. Ein anderes wählen.</translation>
    </message>
    <message>
        <source>This study is read-only; copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt; die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>The protocol has problems. Fix them in the editor first: %1</source>
        <translation>Das Protokoll hat Probleme. Zuerst im Editor beheben: %1</translation>
    </message>
    <message>
        <source>The protocol would not be valid: %1</source>
        <translation>Das Protokoll wäre nicht gültig: %1</translation>
    </message>
    <message>
        <source>The surface already has these values.</source>
        <translation>Die Oberfläche hat diese Werte bereits.</translation>
    </message>
    <message>
        <source>The changed protocol is valid.</source>
        <translation>Das geänderte Protokoll ist gültig.</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
    <message>
        <source>This rendering cannot be used here.</source>
        <translation>Diese Wiedergabe ist hier nicht verwendbar.</translation>
    </message>
    <message>
        <source>The changed protocol is valid, with warnings.</source>
        <translation>Das geänderte Protokoll ist gültig, mit Warnungen.</translation>
    </message>
    <message>
        <source>No block presents the new surface yet: choose it under Task in the editor.</source>
        <translation>Noch bietet kein Block die neue Oberfläche dar: im Editor unter Aufgabe wählen.</translation>
    </message>
    <message>
        <source>Change the protocol&apos;s file</source>
        <translation>Datei des Protokolls ändern</translation>
    </message>
    <message>
        <source>The file is stored at once, without unsaved changes of the editor.</source>
        <translation>Die Datei wird sofort gespeichert, ohne ungespeicherte Änderungen des Editors.</translation>
    </message>
</context>
<context>
    <name>asperity::WelcomePage</name>
    <message>
        <source>Asperity</source>
        <translation>Asperity</translation>
    </message>
    <message>
        <source>Create a study…</source>
        <translation>Studie anlegen…</translation>
    </message>
    <message>
        <source>Open a study…</source>
        <translation>Studie öffnen…</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Demonstration</translation>
    </message>
    <message>
        <source>Open the demo study</source>
        <translation>Demostudie öffnen</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Anderer Ordner…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping after the current texture…</source>
        <translation>Stopp nach der aktuellen Textur…</translation>
    </message>
    <message>
        <source>Folder for the demo study</source>
        <translation>Ordner für die Demostudie</translation>
    </message>
    <message>
        <source>Recent studies</source>
        <translation>Zuletzt benutzte Studien</translation>
    </message>
    <message>
        <source>None yet. Studies that you open are listed here, the most recently used first.</source>
        <translation>Noch keine. Studien, die geöffnet wurden, stehen hier, die zuletzt benutzte zuerst.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Last used</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Aus dieser Liste entfernen</translation>
    </message>
    <message>
        <source>Select a study in the list.</source>
        <translation>Eine Studie in der Liste auswählen.</translation>
    </message>
    <message>
        <source>This folder no longer contains a study; restore the study, or remove it from this list.</source>
        <translation>Dieser Ordner enthält keine Studie mehr; die Studie wiederherstellen oder aus dieser Liste entfernen.</translation>
    </message>
    <message>
        <source>The demo study could not be created: %1</source>
        <translation>Die Demostudie konnte nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>The demo study is in %1.</source>
        <translation>Die Demostudie liegt in %1.</translation>
    </message>
    <message>
        <source>Textures and protocols of every kind, ready to run with the simulated device. No hardware and no network are needed.</source>
        <translation>Texturen und Protokolle jeder Art, bereit für das simulierte Gerät. Weder Hardware noch ein Netzwerk ist nötig.</translation>
    </message>
    <message>
        <source>Creating the demo study in %1…</source>
        <translation>Die Demostudie wird in %1 angelegt…</translation>
    </message>
    <message>
        <source>Psychophysics experiments on haptic texture: participants feel rendered surfaces, compare them with pictures, and report what they felt.
A study is a folder with its protocols, its stimuli, and all responses and recordings.</source>
        <translation>Psychophysische Experimente zu haptischen Texturen: Versuchspersonen fühlen wiedergegebene Oberflächen, vergleichen sie mit Bildern und geben an, was sie gefühlt haben.
Eine Studie ist ein Ordner mit ihren Protokollen, ihren Reizen und allen Antworten und Aufzeichnungen.</translation>
    </message>
    <message>
        <source>study not found</source>
        <translation>Studie nicht gefunden</translation>
    </message>
    <message>
        <source>The demo study will be created in %1 (about 25 MB). This takes a few seconds.</source>
        <translation>Die Demostudie wird in %1 angelegt (etwa 25 MB). Das dauert einige Sekunden.</translation>
    </message>
</context>
<context>
    <name>asperity::WithdrawDialog</name>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n Sitzung</numerusform>
            <numerusform>%n Sitzungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n response(s)</source>
        <translation>
            <numerusform>%n Antwort</numerusform>
            <numerusform>%n Antworten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s)</source>
        <translation>
            <numerusform>%n Aufzeichnung</numerusform>
            <numerusform>%n Aufzeichnungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Withdraw a participant</source>
        <translation>Teilnahme zurückziehen</translation>
    </message>
    <message>
        <source>Withdrawal of %1</source>
        <translation>Rückzug von %1</translation>
    </message>
    <message>
        <source>Keep the data but exclude them from all analyses</source>
        <translation>Die Daten aufbewahren, aber von allen Auswertungen ausschließen</translation>
    </message>
    <message>
        <source>Delete all data of this participant from the study&apos;s folder</source>
        <translation>Alle Daten dieser Versuchsperson aus dem Ordner der Studie löschen</translation>
    </message>
    <message>
        <source>This has already been done.</source>
        <translation>Das ist bereits geschehen.</translation>
    </message>
    <message>
        <source>All sessions are excluded permanently, none can be begun or resumed, and the counterbalancing row is free again.</source>
        <translation>Alle Sitzungen sind endgültig ausgeschlossen, keine kann begonnen oder fortgesetzt werden, und die Zeile der Ausbalancierung ist wieder frei.</translation>
    </message>
    <message>
        <source>Consent withdrawn</source>
        <translation>Einwilligung widerrufen</translation>
    </message>
    <message>
        <source>Not eligible</source>
        <translation>Nicht teilnahmeberechtigt</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderer Grund</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Decided by</source>
        <translation>Entschieden von</translation>
    </message>
    <message>
        <source>Label for confirmation</source>
        <translation>Kürzel zur Bestätigung</translation>
    </message>
    <message>
        <source>Delete the data</source>
        <translation>Daten löschen</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>This study is read-only; copy it to a folder that you may write to.</source>
        <translation>Diese Studie ist schreibgeschützt; die Studie in einen beschreibbaren Ordner kopieren.</translation>
    </message>
    <message>
        <source>Enter who decided this; the name is stored with the time.</source>
        <translation>Eingeben, wer dies entschieden hat; der Name wird mit dem Zeitpunkt gespeichert.</translation>
    </message>
    <message>
        <source>Enter %1 to confirm the deletion.</source>
        <translation>Zur Bestätigung der Löschung %1 eingeben.</translation>
    </message>
    <message>
        <source>Deleting the data…</source>
        <translation>Die Daten werden gelöscht…</translation>
    </message>
    <message>
        <source>Storing the withdrawal…</source>
        <translation>Der Rückzug wird gespeichert…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Deleted: %1.</source>
        <translation>Gelöscht: %1.</translation>
    </message>
    <message>
        <source>Kept and excluded from every analysis: %1.</source>
        <translation>Aufbewahrt und von allen Auswertungen ausgeschlossen: %1.</translation>
    </message>
    <message>
        <source>Rows, recordings and stored older versions of the study are deleted and cannot be restored. Only the fact, time and reason of the withdrawal remain stored.</source>
        <translation>Zeilen, Aufzeichnungen und die aufbewahrten älteren Fassungen der Studie werden gelöscht und sind nicht wiederherzustellen. Nur Tatsache, Zeitpunkt und Grund des Rückzugs bleiben gespeichert.</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>%2, %1: %3</source>
        <translation>%2, %1: %3</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>nicht vollständig</translation>
    </message>
    <message>
        <source>(path with the label of another participant)</source>
        <translation>(Pfad mit dem Kürzel einer anderen Versuchsperson)</translation>
    </message>
    <message>
        <source>Exports, reports and copies</source>
        <translation>Exporte, Berichte und Kopien</translation>
    </message>
    <message>
        <source>Data of %1 in the study: %2.</source>
        <translation>Daten von %1 in der Studie: %2.</translation>
    </message>
    <message>
        <source>These exports, reports and copies of the study are not changed. Each may contain data of %1:</source>
        <translation>Diese Exporte, Berichte und Kopien der Studie werden nicht geändert. Sie können Daten von %1 enthalten:</translation>
    </message>
</context>
<context>
    <name>asperity::WorkbenchPage</name>
    <message>
        <source>Drop a photograph of a surface here</source>
        <translation>Hier ein Foto einer Oberfläche ablegen</translation>
    </message>
    <message>
        <source>It becomes a relief that can be felt: uneven light is corrected, long wavelengths are removed, and the remaining brightness is read as height. PNG, JPEG, TIFF, BMP and WebP are read. A picture in even light, taken from directly above, gives the best result.</source>
        <translation>Daraus wird ein Relief zum Fühlen: Ungleichmäßiges Licht wird ausgeglichen, große Wellenlängen werden entfernt, und die verbleibende Helligkeit gilt als Höhe. PNG, JPEG, TIFF, BMP und WebP werden gelesen. Am besten eignet sich ein Bild in gleichmäßigem Licht, senkrecht von oben aufgenommen.</translation>
    </message>
    <message>
        <source>Open a photograph…</source>
        <translation>Foto öffnen…</translation>
    </message>
    <message>
        <source>Workbench</source>
        <translation>Werkstatt</translation>
    </message>
    <message>
        <source>Make a relief</source>
        <translation>Relief erzeugen</translation>
    </message>
    <message>
        <source>Compare force models</source>
        <translation>Kraftmodelle vergleichen</translation>
    </message>
    <message>
        <source>Relief of the study</source>
        <translation>Relief der Studie</translation>
    </message>
    <message>
        <source>Profile along the orange line</source>
        <translation>Profil entlang der orangen Linie</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Ort, mm</translation>
    </message>
    <message>
        <source>Height, µm</source>
        <translation>Höhe, µm</translation>
    </message>
    <message>
        <source>Spectrum of the profile</source>
        <translation>Spektrum des Profils</translation>
    </message>
    <message>
        <source>Spatial frequency, 1/mm</source>
        <translation>Ortsfrequenz, 1/mm</translation>
    </message>
    <message>
        <source>Power spectral density, µm² mm</source>
        <translation>Leistungsdichte, µm² mm</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>Power, N²/Hz</source>
        <translation>Leistung, N²/Hz</translation>
    </message>
    <message>
        <source>This study has no relief yet</source>
        <translation>Diese Studie hat noch kein Relief</translation>
    </message>
    <message>
        <source>Open a photograph of a surface</source>
        <translation>Foto einer Oberfläche öffnen</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen…</translation>
    </message>
    <message>
        <source>The file could not be opened: %1</source>
        <translation>Die Datei konnte nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>Heights are exaggerated by a factor of %1.</source>
        <translation>Höhen sind %1-fach überhöht gezeichnet.</translation>
    </message>
    <message>
        <source>Heights are drawn to scale.</source>
        <translation>Höhen sind maßstäblich gezeichnet.</translation>
    </message>
    <message>
        <source>%1 Drag to turn, right button: light, wheel: zoom.</source>
        <translation>%1 Ziehen: drehen, rechte Taste: Licht, Rad: zoomen.</translation>
    </message>
    <message>
        <source>%1 Drag to stroke, right button: light, arrow keys: turn.</source>
        <translation>%1 Ziehen: streichen, rechte Taste: Licht, Pfeiltasten: drehen.</translation>
    </message>
    <message>
        <source>Drag over the relief to feel it</source>
        <translation>Über das Relief ziehen, um es zu fühlen</translation>
    </message>
    <message>
        <source>Shown after a quarter of a second</source>
        <translation>Erscheint nach einer Viertelsekunde</translation>
    </message>
    <message>
        <source>The relief in the workbench is not saved and would be lost: save it, then change the theme or the language.</source>
        <translation>Das Relief in der Werkstatt ist nicht gespeichert und ginge verloren: erst speichern, dann Farben oder Sprache wechseln.</translation>
    </message>
    <message>
        <source>Reading the file was cancelled; to read it, open it again.</source>
        <translation>Das Lesen der Datei wurde abgebrochen; um sie zu lesen, sie erneut öffnen.</translation>
    </message>
    <message>
        <source>%1 files were dropped; only the first is shown: %2.</source>
        <translation>Es wurden %1 Dateien abgelegt; gezeigt wird nur die erste: %2.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2. This relief comes from a file of the study and is finished. Compare how the force models render it, or open a photograph to make another relief.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2. Dieses Relief stammt aus einer Datei der Studie und ist fertig. Vergleichen, wie die Kraftmodelle es wiedergeben, oder ein Foto öffnen, um ein anderes Relief zu erzeugen.</translation>
    </message>
    <message>
        <source>Predicted roughness</source>
        <translation>Vorhergesagte Rauheit</translation>
    </message>
    <message>
        <source>RMS acceleration, m/s²</source>
        <translation>Effektivwert der Beschleunigung, m/s²</translation>
    </message>
    <message>
        <source>Shown after half a second</source>
        <translation>Erscheint nach einer halben Sekunde</translation>
    </message>
    <message>
        <source>Predicted acceleration of a hand-held tool of 50 g under the force of the last second of this stroke, computed as in asperity sweep.</source>
        <translation>Vorhergesagte Beschleunigung eines in der Hand gehaltenen Werkzeugs von 50 g, auf das die Kraft der letzten Sekunde dieses Strichs wirkt; berechnet wie mit asperity sweep.</translation>
    </message>
    <message>
        <source>Photographs and measured surfaces (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.webp *.x3p *.sur *.gwy)</source>
        <translation>Fotos und gemessene Oberflächen (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.webp *.x3p *.sur *.gwy)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: %2. This relief was measured; its least-squares plane was subtracted. Compare how the force models render it. To use it in the study, convert the file with “asperity texture”.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: %2. Dieses Relief wurde gemessen; seine Ausgleichsebene wurde abgezogen. Vergleichen Sie, wie die Kraftmodelle es wiedergeben. Um es in der Studie zu verwenden, wandeln Sie die Datei mit „asperity texture“ um.</translation>
    </message>
    <message>
        <source>%1 The dent is that of “%2”, with the same factor. Drag to stroke, right button: light, arrow keys: turn.</source>
        <translation>%1 Die Delle ist die von „%2“, mit demselben Faktor. Ziehen: streichen, rechte Taste: Licht, Pfeiltasten: drehen.</translation>
    </message>
    <message>
        <source>Preparing the models…</source>
        <translation>Modelle werden vorbereitet …</translation>
    </message>
    <message>
        <source>Save the relief to the study first, under “Make a relief”.</source>
        <translation>Zuerst das Relief in der Studie speichern, unter „Relief erzeugen“.</translation>
    </message>
    <message>
        <source>A rendering lies on the plane. Choose the plane as the body under Surface and hand.</source>
        <translation>Eine Wiedergabe liegt auf der Ebene. Unter Oberfläche und Hand die Ebene als Körper wählen.</translation>
    </message>
    <message>
        <source>A rendering contains neither bodies nor recordings; left out: %1.</source>
        <translation>Eine Wiedergabe enthält weder Körper noch Aufnahmen; ausgelassen: %1.</translation>
    </message>
    <message>
        <source>This relief was measured. Convert its file with “asperity texture”, then open the result.</source>
        <translation>Dieses Relief wurde gemessen. Die Datei mit „asperity texture“ umwandeln, dann das Ergebnis öffnen.</translation>
    </message>
    <message>
        <source>This relief is not in the study. Copy the file with its sidecar into the folder stimuli of the study, then open it from there.</source>
        <translation>Dieses Relief ist nicht in der Studie. Die Datei mit ihrer Begleitdatei in den Ordner stimuli der Studie kopieren, dann von dort öffnen.</translation>
    </message>
</context>
</TS>
