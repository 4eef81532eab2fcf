<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>core</name>
    <message>
        <source>doubtful for too long: %1</source>
        <translation>zu lange unsicher: %1</translation>
    </message>
    <message>
        <source>given up: %1</source>
        <translation>aufgegeben: %1</translation>
    </message>
    <message>
        <source>no position: %1</source>
        <translation>keine Position: %1</translation>
    </message>
    <message>
        <source>the match is right with a probability of only %1 %</source>
        <translation>der Treffer stimmt nur mit einer Wahrscheinlichkeit von %1 %</translation>
    </message>
    <message>
        <source>the likest place in the left picture is right with a probability of only %1 %</source>
        <translation>die ähnlichste Stelle im linken Bild stimmt nur mit einer Wahrscheinlichkeit von %1 %</translation>
    </message>
    <message>
        <source>another place where it may be looks the same</source>
        <translation>eine andere Stelle, an der es sein kann, sieht ebenso aus</translation>
    </message>
    <message>
        <source>what looks most like it is not where it may be</source>
        <translation>was ihm am ähnlichsten ist, liegt nicht, wo es sein kann</translation>
    </message>
    <message>
        <source>looking for it: nothing in the left picture is clearly it</source>
        <translation>wird gesucht: nichts im linken Bild ist es eindeutig</translation>
    </message>
    <message>
        <source>the predicted place is outside the left picture</source>
        <translation>die vorhergesagte Stelle liegt außerhalb des linken Bilds</translation>
    </message>
    <message>
        <source>not found in the right picture</source>
        <translation>im rechten Bild nicht gefunden</translation>
    </message>
    <message>
        <source>the right picture holds another place that looks the same</source>
        <translation>im rechten Bild sieht eine andere Stelle gleich aus</translation>
    </message>
    <message>
        <source>its distance would have leapt from %1 to %2 m</source>
        <translation>seine Entfernung wäre von %1 auf %2 m gesprungen</translation>
    </message>
    <message>
        <source>%1 -&gt; %2: %3</source>
        <translation>%1 -&gt; %2: %3</translation>
    </message>
    <message>
        <source>%1 -&gt; %2</source>
        <translation>%1 -&gt; %2</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Ohne Ziel</translation>
    </message>
    <message>
        <source>TemplateSet</source>
        <translation>Vorlage gewählt</translation>
    </message>
    <message>
        <source>Template set</source>
        <translation>Vorlage gewählt</translation>
    </message>
    <message>
        <source>Tracking</source>
        <translation>Verfolgt</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Unsicher</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>The source has come to its end.</source>
        <translation>Die Quelle ist zu Ende.</translation>
    </message>
    <message>
        <source>A camera may have moved: the right picture shows things %1 px below where the calibration expects them (median of %2 matches; %3 px would be usual), as if the right camera had tilted up by %4 degrees against the left one. Check the cameras&apos; mounts, then calibrate again.</source>
        <translation>Eine Kamera hat sich vielleicht verschoben: Das rechte Bild zeigt alles %1 px unter der Stelle, die die Kalibrierung erwartet (Median aus %2 Treffern; üblich wären %3 px), als wäre die rechte Kamera gegen die linke um %4 Grad nach oben gekippt. Die Halterungen der Kameras prüfen, dann neu kalibrieren.</translation>
    </message>
    <message>
        <source>A camera may have moved: the right picture shows things %1 px above where the calibration expects them (median of %2 matches; %3 px would be usual), as if the right camera had tilted down by %4 degrees against the left one. Check the cameras&apos; mounts, then calibrate again.</source>
        <translation>Eine Kamera hat sich vielleicht verschoben: Das rechte Bild zeigt alles %1 px über der Stelle, die die Kalibrierung erwartet (Median aus %2 Treffern; üblich wären %3 px), als wäre die rechte Kamera gegen die linke um %4 Grad nach unten gekippt. Die Halterungen der Kameras prüfen, dann neu kalibrieren.</translation>
    </message>
    <message>
        <source>The cameras see each other&apos;s points where the calibration expects them again (%1 px beside, median of %2 matches).</source>
        <translation>Die Kameras sehen einander entsprechende Punkte wieder dort, wo die Kalibrierung sie erwartet (%1 px daneben, Median aus %2 Treffern).</translation>
    </message>
    <message>
        <source>The template was updated by command.</source>
        <translation>Die Vorlage wurde auf Befehl erneuert.</translation>
    </message>
    <message>
        <source>A new calibration is in use. Choose the template again.</source>
        <translation>Eine neue Kalibrierung gilt. Wählen Sie die Vorlage noch einmal.</translation>
    </message>
    <message>
        <source>There is no template to follow.</source>
        <translation>Es gibt keine Vorlage zum Verfolgen.</translation>
    </message>
    <message>
        <source>Choose one in the left picture first.</source>
        <translation>Wählen Sie erst eine im linken Bild.</translation>
    </message>
    <message>
        <source>The target is not in sight, so its template can&apos;t be updated.</source>
        <translation>Das Ziel ist nicht zu sehen, darum kann seine Vorlage nicht erneuert werden.</translation>
    </message>
    <message>
        <source>Wait until it is tracked, or choose a new template.</source>
        <translation>Warten Sie, bis es verfolgt wird, oder wählen Sie eine neue Vorlage.</translation>
    </message>
    <message>
        <source>Frame %1 is no longer remembered.</source>
        <translation>Bild %1 ist nicht mehr im Gedächtnis.</translation>
    </message>
    <message>
        <source>Choose the template in a newer picture.</source>
        <translation>Wählen Sie die Vorlage in einem neueren Bild.</translation>
    </message>
    <message>
        <source>There is no pan-tilt head.</source>
        <translation>Es gibt keinen Schwenkkopf.</translation>
    </message>
    <message>
        <source>Connect one, or name it when starting.</source>
        <translation>Schließen Sie einen an oder nennen Sie ihn beim Start.</translation>
    </message>
    <message>
        <source>The head can&apos;t look there: it reaches %1 degrees to the sides and %2 up and down.</source>
        <translation>Dorthin kann der Kopf nicht blicken: er reicht %1 Grad zur Seite und %2 nach oben und unten.</translation>
    </message>
    <message>
        <source>Give angles within these limits.</source>
        <translation>Geben Sie Winkel innerhalb dieser Grenzen an.</translation>
    </message>
    <message>
        <source>The rig file does not say where the pan-tilt camera is.</source>
        <translation>Die Kalibrierdatei sagt nicht, wo die Schwenkkamera ist.</translation>
    </message>
    <message>
        <source>Calibrate it with the others, then hand over the steering.</source>
        <translation>Kalibrieren Sie sie mit den anderen, dann übergeben Sie die Nachführung.</translation>
    </message>
    <message>
        <source>The source is over: there are no more pictures to take.</source>
        <translation>Die Quelle ist zu Ende: es kommen keine Bilder mehr.</translation>
    </message>
    <message>
        <source>Go back to an earlier frame, or open it again.</source>
        <translation>Gehen Sie zu einem früheren Bild zurück oder öffnen Sie sie neu.</translation>
    </message>
    <message>
        <source>There is no frame %1: the recording has %2.</source>
        <translation>Es gibt kein Bild %1: die Aufnahme hat %2.</translation>
    </message>
    <message>
        <source>Live pictures can&apos;t be wound to another frame.</source>
        <translation>Livebilder lassen sich nicht zu einem anderen Bild spulen.</translation>
    </message>
    <message>
        <source>Open a recording.</source>
        <translation>Öffnen Sie eine Aufnahme.</translation>
    </message>
    <message>
        <source>The template %1 is not inside the picture of %2 pixels.</source>
        <translation>Die Vorlage %1 liegt nicht im Bild von %2 Pixeln.</translation>
    </message>
    <message>
        <source>Choose a rectangle that lies wholly inside.</source>
        <translation>Wählen Sie ein Rechteck, das ganz darin liegt.</translation>
    </message>
    <message>
        <source>The template %1 is too small to be followed.</source>
        <translation>Die Vorlage %1 ist zu klein, um verfolgt zu werden.</translation>
    </message>
    <message>
        <source>Choose at least 7 x 7 pixels; 21 x 21 is a good size.</source>
        <translation>Wählen Sie mindestens 7 x 7 Pixel; 21 x 21 ist eine gute Größe.</translation>
    </message>
    <message>
        <source>The template %1 is too large to be followed.</source>
        <translation>Die Vorlage %1 ist zu groß, um verfolgt zu werden.</translation>
    </message>
    <message>
        <source>Choose at most 255 x 255 pixels; 31 x 31 is a good size.</source>
        <translation>Wählen Sie höchstens 255 x 255 Pixel; 31 x 31 ist eine gute Größe.</translation>
    </message>
    <message>
        <source>The template %1 has no texture: its grey levels vary by %2, noise included.</source>
        <translation>Die Vorlage %1 hat keine Struktur: ihre Grauwerte schwanken um %2, Rauschen eingerechnet.</translation>
    </message>
    <message>
        <source>Choose a piece with marks or edges, or a larger one.</source>
        <translation>Wählen Sie ein Stück mit Zeichen oder Kanten oder ein größeres.</translation>
    </message>
    <message>
        <source>The template %1 has texture in one direction only and would slide along it.</source>
        <translation>Die Vorlage %1 hat nur in einer Richtung Struktur und würde daran entlanggleiten.</translation>
    </message>
    <message>
        <source>Include a corner, an end of the edge or another mark.</source>
        <translation>Nehmen Sie eine Ecke, das Ende der Kante oder ein anderes Zeichen hinein.</translation>
    </message>
    <message>
        <source>The template %1 lies where the left lens&apos;s calibration does not reach.</source>
        <translation>Die Vorlage %1 liegt dort, wohin die Kalibrierung der linken Linse nicht reicht.</translation>
    </message>
    <message>
        <source>Choose a place nearer to the middle of the picture.</source>
        <translation>Wählen Sie eine Stelle näher an der Bildmitte.</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>Es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>Check the name and the folder.</source>
        <translation>Prüfen Sie Namen und Ordner.</translation>
    </message>
    <message>
        <source>No pictures have come from the cameras within five seconds.</source>
        <translation>Innerhalb von fünf Sekunden kamen keine Bilder von den Kameras.</translation>
    </message>
    <message>
        <source>Check that they are connected and that nothing else uses them.</source>
        <translation>Prüfen Sie, ob sie angeschlossen sind und nichts anderes sie benutzt.</translation>
    </message>
    <message>
        <source>The left and right recordings have different lengths: %1 ends after %2 frames, %3 goes on.</source>
        <translation>Die linke und die rechte Aufnahme sind verschieden lang: %1 endet nach %2 Bildern, %3 geht weiter.</translation>
    </message>
    <message>
        <source>Give two recordings of the same instants, or cut the longer one.</source>
        <translation>Geben Sie zwei Aufnahmen derselben Augenblicke an oder kürzen Sie die längere.</translation>
    </message>
    <message>
        <source>The pictures are %1 pixels, but the rig file is for %2, which is another shape.</source>
        <translation>Die Bilder haben %1 Pixel, die Kalibrierdatei gilt aber für %2, und das ist eine andere Form.</translation>
    </message>
    <message>
        <source>Use the rig file that belongs to these pictures, or calibrate anew.</source>
        <translation>Nehmen Sie die Kalibrierdatei, die zu diesen Bildern gehört, oder kalibrieren Sie neu.</translation>
    </message>
    <message>
        <source>No file fits the pattern %1.</source>
        <translation>Zum Muster %1 passt keine Datei.</translation>
    </message>
    <message>
        <source>Check the folder and the pattern; on a command line, quote it.</source>
        <translation>Prüfen Sie Ordner und Muster; auf der Kommandozeile gehört es in Anführungszeichen.</translation>
    </message>
    <message>
        <source>The pattern %1 is not understood.</source>
        <translation>Das Muster %1 ist nicht verständlich.</translation>
    </message>
    <message>
        <source>Use one number form such as left/%06d.png, or left/*.png.</source>
        <translation>Geben Sie eine Zahlenform wie links/%06d.png oder links/*.png.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>Check the name.</source>
        <translation>Prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>%1 is a folder.</source>
        <translation>%1 ist ein Ordner.</translation>
    </message>
    <message>
        <source>Name its pictures, for example %1.</source>
        <translation>Nennen Sie seine Bilder, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>%1 can&apos;t be read as a picture: it is damaged, cut short or of another kind.</source>
        <translation>%1 ist nicht als Bild lesbar: beschädigt, abgeschnitten oder von anderer Art.</translation>
    </message>
    <message>
        <source>Check the file, or leave it out.</source>
        <translation>Prüfen Sie die Datei, oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>%1 can&apos;t be read as a video: it is damaged, cut short or of another kind.</source>
        <translation>%1 ist nicht als Video lesbar: beschädigt, abgeschnitten oder von anderer Art.</translation>
    </message>
    <message>
        <source>Check that it plays elsewhere, or give pictures instead.</source>
        <translation>Prüfen Sie, ob es anderswo läuft, oder geben Sie stattdessen Bilder.</translation>
    </message>
    <message>
        <source>The video %1 is cut short: it announces %2 frames, but only %3 can be read.</source>
        <translation>Das Video %1 ist abgeschnitten: Es kündigt %2 Bilder an, lesbar sind nur %3.</translation>
    </message>
    <message>
        <source>Copy it again from where it was recorded, or cut it at that frame.</source>
        <translation>Kopieren Sie es noch einmal vom Ort der Aufnahme, oder schneiden Sie es bei diesem Bild ab.</translation>
    </message>
    <message>
        <source>%1 has %2 pixels, the pictures before it %3.</source>
        <translation>%1 hat %2 Bildpunkte, die Bilder davor %3.</translation>
    </message>
    <message>
        <source>The left pictures are %1 pixels, the right ones %2.</source>
        <translation>Die linken Bilder haben %1 Bildpunkte, die rechten %2.</translation>
    </message>
    <message>
        <source>Give two sources of the same size.</source>
        <translation>Geben Sie zwei Quellen gleicher Größe.</translation>
    </message>
    <message>
        <source>The rig file holds no right camera.</source>
        <translation>Die Kalibrierdatei enthält keine rechte Kamera.</translation>
    </message>
    <message>
        <source>Calibrate both cameras, or leave the right source out.</source>
        <translation>Kalibrieren Sie beide Kameras, oder lassen Sie die rechte Quelle weg.</translation>
    </message>
    <message>
        <source>The rig file is not valid YAML (%1).</source>
        <translation>Die Kalibrierdatei ist kein gültiges YAML (%1).</translation>
    </message>
    <message>
        <source>Mend the file, or make it anew with calibrate or convert.</source>
        <translation>Berichtigen Sie die Datei, oder erzeugen Sie sie neu mit calibrate oder convert.</translation>
    </message>
    <message>
        <source>There is no rig file.</source>
        <translation>Es fehlt die Kalibrierdatei.</translation>
    </message>
    <message>
        <source>Name one with --rig.</source>
        <translation>Nennen Sie eine mit --rig.</translation>
    </message>
    <message>
        <source>Target %1: %2</source>
        <translation>Ziel %1: %2</translation>
    </message>
    <message>
        <source>The head is steered to target %1 now.</source>
        <translation>Der Kopf folgt jetzt Ziel %1.</translation>
    </message>
    <message>
        <source>There is no target %1.</source>
        <translation>Es gibt kein Ziel %1.</translation>
    </message>
    <message>
        <source>Choose it in the left picture first.</source>
        <translation>Wählen Sie es erst im linken Bild.</translation>
    </message>
    <message>
        <source>Targets have the numbers 1 to %1: there can&apos;t be a target %2.</source>
        <translation>Ziele haben die Nummern 1 bis %1: ein Ziel %2 kann es nicht geben.</translation>
    </message>
    <message>
        <source>Clear a target, then choose this one with its number.</source>
        <translation>Löschen Sie ein Ziel und wählen Sie dieses dann mit dessen Nummer.</translation>
    </message>
    <message>
        <source>The head answers.</source>
        <translation>Der Kopf antwortet.</translation>
    </message>
    <message>
        <source>The head answers again.</source>
        <translation>Der Kopf antwortet wieder.</translation>
    </message>
    <message>
        <source>The head does not answer. Check its power, the line and the address.</source>
        <translation>Der Kopf antwortet nicht. Prüfen Sie Strom, Leitung und Adresse.</translation>
    </message>
    <message>
        <source>The head does not answer any more; trying to reach it.</source>
        <translation>Der Kopf antwortet nicht mehr; es wird versucht, ihn zu erreichen.</translation>
    </message>
    <message>
        <source>The line to the head (%1) was lost (%2).</source>
        <translation>Die Leitung zum Kopf (%1) ist unterbrochen (%2).</translation>
    </message>
    <message>
        <source>Plug it in again; it is tried on and on.</source>
        <translation>Stecken Sie sie wieder ein; es wird immer wieder versucht.</translation>
    </message>
    <message>
        <source>The line to the head (%1) is there again.</source>
        <translation>Die Leitung zum Kopf (%1) ist wieder da.</translation>
    </message>
    <message>
        <source>The line to the head (%1) can&apos;t be opened (%2).</source>
        <translation>Die Leitung zum Kopf (%1) lässt sich nicht öffnen (%2).</translation>
    </message>
    <message>
        <source>Check that it is plugged in and switched on, its name, and the right to use it.</source>
        <translation>Prüfen Sie, ob er eingesteckt und eingeschaltet ist, den Namen und das Recht, ihn zu benutzen.</translation>
    </message>
    <message>
        <source>The head (%1) does not answer. Check its power and the line.</source>
        <translation>Der Kopf (%1) antwortet nicht. Prüfen Sie Strom und Leitung.</translation>
    </message>
    <message>
        <source>The head was switched on, or the chain has changed: starting anew.</source>
        <translation>Der Kopf wurde eingeschaltet, oder die Kette hat sich geändert: es wird neu begonnen.</translation>
    </message>
    <message>
        <source>The head is in standby: it is switched on.</source>
        <translation>Der Kopf ist in Bereitschaft: er wird eingeschaltet.</translation>
    </message>
    <message>
        <source>The head came to rest elsewhere: it is told again.</source>
        <translation>Der Kopf kam anderswo zur Ruhe: es wird ihm noch einmal gesagt.</translation>
    </message>
    <message>
        <source>The head stays %1 steps short of where it should look.</source>
        <translation>Der Kopf bleibt %1 Schritte vor dem, wohin er blicken soll.</translation>
    </message>
    <message>
        <source>The head said to be where it can&apos;t be; asked again.</source>
        <translation>Der Kopf nannte eine Stellung, die nicht sein kann; er wird noch einmal gefragt.</translation>
    </message>
    <message>
        <source>%1 bytes from the head made no sense and were passed over.</source>
        <translation>%1 Bytes vom Kopf waren unverständlich und wurden übergangen.</translation>
    </message>
    <message>
        <source>The target is not held still yet.</source>
        <translation>Der Zielkörper wird noch nicht still gehalten.</translation>
    </message>
    <message>
        <source>The target is where shot %1 shows it already: move it.</source>
        <translation>Der Zielkörper ist, wo ihn Aufnahme %1 schon zeigt: Bewegen Sie ihn.</translation>
    </message>
    <message>
        <source>The %1 camera does not find the target: %2</source>
        <translation>Die Kamera %1 findet den Zielkörper nicht: %2</translation>
    </message>
    <message>
        <source>The %1 camera does not find the target.</source>
        <translation>Die Kamera %1 findet den Zielkörper nicht.</translation>
    </message>
    <message>
        <source>The %1 picture is blurred: edges are %2 px wide.</source>
        <translation>Das Bild %1 ist unscharf: Kanten sind %2 px breit.</translation>
    </message>
    <message>
        <source>The %1 picture shows the corners to %2 px only: too dark, too small, or blurred.</source>
        <translation>Das Bild %1 zeigt die Ecken nur auf %2 px genau: zu dunkel, zu klein oder unscharf.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s pictures have another size than the session began with.</source>
        <translation>Die Bilder der Kamera %1 haben eine andere Größe als zu Beginn der Sitzung.</translation>
    </message>
    <message>
        <source>The pan-tilt head is not at home: turn it home first.</source>
        <translation>Der Schwenkkopf ist nicht in Ruhestellung: Drehen Sie ihn erst dorthin.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>The folder %1 can&apos;t be made: %2.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden: %2.</translation>
    </message>
    <message>
        <source>Choose a place that can be written to.</source>
        <translation>Wählen Sie einen Ort, an dem geschrieben werden darf.</translation>
    </message>
    <message>
        <source>%1 holds a calibration session already.</source>
        <translation>%1 enthält schon eine Kalibriersitzung.</translation>
    </message>
    <message>
        <source>Resume it, or choose another folder.</source>
        <translation>Setzen Sie sie fort oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The scale rests on the target&apos;s sizes alone; a baseline measured by tape would check them.</source>
        <translation>Der Maßstab beruht allein auf den Maßen des Zielkörpers; eine mit dem Maßband gemessene Basislinie würde ihn prüfen.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>pan_tilt</source>
        <translation>Schwenk-Neige</translation>
    </message>
    <message>
        <source>It was stopped before its end.</source>
        <translation>Es wurde vor dem Ende abgebrochen.</translation>
    </message>
    <message>
        <source>Only %1 views show the target; at least %2 are needed.</source>
        <translation>Nur %1 Ansichten zeigen den Zielkörper; mindestens %2 sind nötig.</translation>
    </message>
    <message>
        <source>Only %1 views show the target to two cameras; at least %2 are needed.</source>
        <translation>Nur %1 Ansichten zeigen den Zielkörper zwei Kameras; mindestens %2 sind nötig.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s views determine no lens: show the target larger, at several angles and distances.</source>
        <translation>Kamera %1: Die Ansichten bestimmen kein Objektiv. Zeigen Sie den Zielkörper größer, unter mehreren Winkeln und Entfernungen.</translation>
    </message>
    <message>
        <source>No view of the %1 camera fits the target: check which target it is, and its numbers.</source>
        <translation>Kamera %1: Keine Ansicht passt zum Zielkörper. Prüfen Sie, welcher es ist, und seine Maße.</translation>
    </message>
    <message>
        <source>No view shows the target to both the %1 and the %2 camera.</source>
        <translation>Keine Ansicht zeigt den Zielkörper beiden Kameras %1 und %2.</translation>
    </message>
    <message>
        <source>The pictures of the %1 and the %2 camera do not belong together: only %3 of %4 pairs agree on where the cameras stand. Check that both lists are in the same order, taken at the same instants, and neither mirrored.</source>
        <translation>Die Bilder der Kameras %1 und %2 gehören nicht zusammen: Nur %3 von %4 Paaren stimmen darin überein, wo die Kameras stehen. Prüfen Sie, dass beide Listen gleich geordnet, zu gleichen Zeitpunkten aufgenommen und nicht gespiegelt sind.</translation>
    </message>
    <message>
        <source>Only %1 views fit each other; at least %2 are needed.</source>
        <translation>Nur %1 Ansichten passen zueinander; mindestens %2 sind nötig.</translation>
    </message>
    <message>
        <source>The views do not determine the cameras: show the target at more angles and distances.</source>
        <translation>Die Ansichten bestimmen die Kameras nicht: Zeigen Sie den Zielkörper unter mehr Winkeln und Entfernungen.</translation>
    </message>
    <message>
        <source>Pictures show the target mirrored and are left out: turn off the camera&apos;s or the driver&apos;s mirroring.</source>
        <translation>Bilder zeigen den Zielkörper gespiegelt und bleiben weg: Schalten Sie die Spiegelung von Kamera oder Treiber aus.</translation>
    </message>
    <message>
        <source>%1 view repeats a picture of another view; each counts once. Move the target between pictures.</source>
        <translation>%1 Ansicht wiederholt ein Bild einer anderen; jedes zählt einmal. Bewegen Sie den Zielkörper zwischen den Bildern.</translation>
    </message>
    <message>
        <source>%1 views repeat a picture of another view; each counts once. Move the target between pictures.</source>
        <translation>%1 Ansichten wiederholen ein Bild einer anderen; jedes zählt einmal. Bewegen Sie den Zielkörper zwischen den Bildern.</translation>
    </message>
    <message>
        <source>%1 view does not fit the others and is left out; the list of views says why.</source>
        <translation>%1 Ansicht passt nicht zu den anderen und bleibt weg; die Liste der Ansichten sagt, warum.</translation>
    </message>
    <message>
        <source>%1 views do not fit the others and are left out; the list of views says why.</source>
        <translation>%1 Ansichten passen nicht zu den anderen und bleiben weg; die Liste der Ansichten sagt, warum.</translation>
    </message>
    <message>
        <source>too few corners are seen</source>
        <translation>zu wenige Ecken sind zu sehen</translation>
    </message>
    <message>
        <source>the target is mirrored in this picture</source>
        <translation>der Zielkörper ist in diesem Bild gespiegelt</translation>
    </message>
    <message>
        <source>the %1 picture is the same as view %2&apos;s</source>
        <translation>das Bild %1 ist dasselbe wie in Ansicht %2</translation>
    </message>
    <message>
        <source>its corners do not fit the target</source>
        <translation>seine Ecken passen nicht zum Zielkörper</translation>
    </message>
    <message>
        <source>fits far worse than the others (%1 px)</source>
        <translation>passt weit schlechter als die anderen (%1 px)</translation>
    </message>
    <message>
        <source>most of its corners contradict the other cameras&apos;</source>
        <translation>die meisten seiner Ecken widersprechen denen der anderen Kameras</translation>
    </message>
    <message>
        <source>the %1 and %2 pictures contradict each other: not the same instant, or another target</source>
        <translation>die Bilder %1 und %2 widersprechen sich: nicht derselbe Zeitpunkt, oder ein anderer Zielkörper</translation>
    </message>
    <message>
        <source>The %1 camera can&apos;t be: %2.</source>
        <translation>Kamera %1: Das kann nicht sein (%2).</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s optical axis comes out at (%2, %3) px, far from the picture&apos;s middle.</source>
        <translation>Kamera %1: Die optische Achse kommt bei (%2, %3) px heraus, weit von der Bildmitte.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s pixels come out %2 off square: check the sensor&apos;s numbers.</source>
        <translation>Kamera %1: Die Pixel kommen um %2 nicht quadratisch heraus. Prüfen Sie die Angaben zum Sensor.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s focal length is open to %2: show the target at more angles and distances.</source>
        <translation>Kamera %1: Die Brennweite ist nur auf %2 bestimmt. Zeigen Sie den Zielkörper unter mehr Winkeln und Entfernungen.</translation>
    </message>
    <message>
        <source>The %1 camera saw the target in %2 of its picture only: show it near the sides and corners, too.</source>
        <translation>Kamera %1 sah den Zielkörper nur in %2 ihres Bildes: Zeigen Sie ihn auch nahe den Rändern und Ecken.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s residuals hang together over the picture (%2 px): the lens model does not describe this lens.</source>
        <translation>Kamera %1: Die Restfehler hängen über das Bild zusammen (%2 px). Das Objektivmodell beschreibt dieses Objektiv nicht.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s pictures are blurred: edges are %2 px wide. Focus, and hold the target still.</source>
        <translation>Kamera %1: Die Bilder sind unscharf, Kanten sind %2 px breit. Stellen Sie scharf und halten Sie den Zielkörper still.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s focal length is %2 times the expected one&apos;s, where %3 should be: the pictures look taken in the other medium.</source>
        <translation>Kamera %1: Die Brennweite ist das %2-Fache der erwarteten, wo %3 sein sollte. Die Bilder scheinen im anderen Medium aufgenommen.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s focal length is %2 times the expected one&apos;s, where %3 should be: another lens, zoom or target size.</source>
        <translation>Kamera %1: Die Brennweite ist das %2-Fache der erwarteten, wo %3 sein sollte. Ein anderes Objektiv, ein anderer Zoom oder eine andere Größe des Zielkörpers.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s kappa1 is %2 / mm2 where %3 is expected: %4 at the side of the picture.</source>
        <translation>Kamera %1: kappa1 ist %2 / mm2, wo %3 erwartet wird: %4 am Bildrand.</translation>
    </message>
    <message>
        <source>The %1 camera&apos;s lens bends by %2 at the side of the picture where %3 is expected.</source>
        <translation>Kamera %1: Das Objektiv verzeichnet am Bildrand um %2, wo %3 erwartet wird.</translation>
    </message>
    <message>
        <source>The residuals are %1 px, more than %2: blurred pictures, another target, or wrong numbers of it.</source>
        <translation>Die Restfehler sind %1 px, mehr als %2: unscharfe Bilder, ein anderer Zielkörper oder falsche Maße.</translation>
    </message>
    <message>
        <source>The residuals are %1 px; below %2 would be good. Blur, motion or an uneven target do this.</source>
        <translation>Die Restfehler sind %1 px; unter %2 wäre gut. Unschärfe, Bewegung oder ein unebener Zielkörper bewirken das.</translation>
    </message>
    <message>
        <source>%1 of the corners fit nowhere and are left out.</source>
        <translation>%1 der Ecken passen nirgends und bleiben weg.</translation>
    </message>
    <message>
        <source>The residuals hang together over the target (%1 px): its sizes and gaps are not as described. Measure it again.</source>
        <translation>Die Restfehler hängen über den Zielkörper zusammen (%1 px): Seine Maße und Abstände sind nicht wie beschrieben. Messen Sie ihn nach.</translation>
    </message>
    <message>
        <source>The target was seen from %1 to %2 mm only: the depth is narrow, and focal length and distance can&apos;t be told apart well. Show it nearer and farther, by a factor of two.</source>
        <translation>Der Zielkörper war nur von %1 bis %2 mm zu sehen: Die Tiefe ist gering, Brennweite und Entfernung sind schlecht zu trennen. Zeigen Sie ihn näher und ferner, um den Faktor zwei.</translation>
    </message>
    <message>
        <source>The right camera comes out to the left of the left one: the sides are exchanged, or all pictures mirrored.</source>
        <translation>Die rechte Kamera kommt links von der linken heraus: Die Seiten sind vertauscht oder alle Bilder gespiegelt.</translation>
    </message>
    <message>
        <source>The left and right focal lengths differ by %1: if both lenses are of one kind, one is wrong.</source>
        <translation>Die Brennweiten links und rechts unterscheiden sich um %1: Sind beide Objektive gleich, ist eine falsch.</translation>
    </message>
    <message>
        <source>The baseline comes out at %1 mm, %2 deviations from the measured %3 mm: check the target&apos;s sizes and the tape.</source>
        <translation>Die Basis kommt mit %1 mm heraus, %2 Abweichungen von den gemessenen %3 mm: Prüfen Sie die Maße des Zielkörpers und das Maßband.</translation>
    </message>
    <message>
        <source>Left and right see no place in common in the working volume: no range there.</source>
        <translation>Links und rechts sehen im Arbeitsraum keine Stelle gemeinsam: dort keine Entfernung.</translation>
    </message>
    <message>
        <source>The calibration leaves ranges open to %1 (one deviation; %2 at worst): too much to measure with.</source>
        <translation>Die Kalibrierung lässt Entfernungen auf %1 offen (eine Standardabweichung; schlimmstens %2): zu viel, um damit zu messen.</translation>
    </message>
    <message>
        <source>The calibration leaves ranges open to %1 (one deviation; %2 at worst): take more views, nearer and farther, to the sides.</source>
        <translation>Die Kalibrierung lässt Entfernungen auf %1 offen (eine Standardabweichung; schlimmstens %2): Nehmen Sie mehr Ansichten auf, näher und ferner, an den Seiten.</translation>
    </message>
    <message>
        <source>Views that took no part come out %1 too large: the calibration does not hold for other views.</source>
        <translation>Ansichten, die nicht beteiligt waren, kommen um %1 zu groß heraus: Die Kalibrierung gilt nicht für andere Ansichten.</translation>
    </message>
    <message>
        <source>Views that took no part come out %1 too small: the calibration does not hold for other views.</source>
        <translation>Ansichten, die nicht beteiligt waren, kommen um %1 zu klein heraus: Die Kalibrierung gilt nicht für andere Ansichten.</translation>
    </message>
    <message>
        <source>Views that took no part come out %1 too large: more views would make it surer.</source>
        <translation>Ansichten, die nicht beteiligt waren, kommen um %1 zu groß heraus: Mehr Ansichten machten es sicherer.</translation>
    </message>
    <message>
        <source>Views that took no part come out %1 too small: more views would make it surer.</source>
        <translation>Ansichten, die nicht beteiligt waren, kommen um %1 zu klein heraus: Mehr Ansichten machten es sicherer.</translation>
    </message>
    <message>
        <source>There is no picture.</source>
        <translation>Es gibt kein Bild.</translation>
    </message>
    <message>
        <source>The left camera does not take part.</source>
        <translation>Die linke Kamera nimmt nicht teil.</translation>
    </message>
    <message>
        <source>A camera&apos;s pictures have no size.</source>
        <translation>Die Bilder einer Kamera haben keine Größe.</translation>
    </message>
    <message>
        <source>The target can&apos;t be: %1.</source>
        <translation>Diesen Zielkörper kann es nicht geben: %1.</translation>
    </message>
    <message>
        <source>A list of points can&apos;t be found in pictures.</source>
        <translation>Eine Liste von Punkten ist in Bildern nicht zu finden.</translation>
    </message>
    <message>
        <source>Choose the cameras and the target first.</source>
        <translation>Wählen Sie zuerst die Kameras und den Zielkörper.</translation>
    </message>
    <message>
        <source>Begin a new session in another folder.</source>
        <translation>Beginnen Sie eine neue Sitzung in einem anderen Ordner.</translation>
    </message>
    <message>
        <source>Mend the file, or begin a new session in another folder.</source>
        <translation>Berichtigen Sie die Datei, oder beginnen Sie eine neue Sitzung in einem anderen Ordner.</translation>
    </message>
    <message>
        <source>Move the shot out of the session&apos;s folder and resume again.</source>
        <translation>Nehmen Sie die Aufnahme aus dem Ordner der Sitzung und setzen Sie sie erneut fort.</translation>
    </message>
    <message>
        <source>Move one of them out of its folder and resume again.</source>
        <translation>Nehmen Sie eine davon aus ihrem Ordner und setzen Sie erneut fort.</translation>
    </message>
    <message>
        <source>There is no shot %1.</source>
        <translation>Es gibt keine Aufnahme %1.</translation>
    </message>
    <message>
        <source>Choose one of the list.</source>
        <translation>Wählen Sie eine aus der Liste.</translation>
    </message>
    <message>
        <source>Only %1 of the target&apos;s boxes are large and clear enough.</source>
        <translation>Nur %1 Kästchen des Zielkörpers sind groß und klar genug.</translation>
    </message>
    <message>
        <source>Bring the target nearer, out of glare.</source>
        <translation>Bringen Sie den Zielkörper näher und aus dem Glanzlicht.</translation>
    </message>
    <message>
        <source>%1 Those seen are about %2 px wide, which is too small.</source>
        <translation>%1 Die sichtbaren sind etwa %2 px breit; das ist zu klein.</translation>
    </message>
    <message>
        <source>%1 One plane shows %2 boxes; others beside it are about %3 px wide, which is too small.</source>
        <translation>%1 Eine Ebene zeigt %2 Kästchen; andere daneben sind etwa %3 px breit; das ist zu klein.</translation>
    </message>
    <message>
        <source>%1 The picture is blurred: its sharpest edges are about %2 px wide.</source>
        <translation>%1 Das Bild ist unscharf: Seine schärfsten Kanten sind etwa %2 px breit.</translation>
    </message>
    <message>
        <source>Bring the target nearer.</source>
        <translation>Bringen Sie den Zielkörper näher.</translation>
    </message>
    <message>
        <source>Turn the target so that it faces the camera with both planes, nearer.</source>
        <translation>Drehen Sie den Zielkörper so, dass er der Kamera beide Ebenen zeigt, und näher.</translation>
    </message>
    <message>
        <source>Focus the lens, or hold the target still.</source>
        <translation>Stellen Sie das Objektiv scharf, oder halten Sie den Zielkörper still.</translation>
    </message>
    <message>
        <source>%1 of the target&apos;s %2 boxes are found, but its round marks are not where they belong.</source>
        <translation>%1 der %2 Kästchen des Zielkörpers sind gefunden, aber seine runden Marken sind nicht, wo sie hingehören.</translation>
    </message>
    <message>
        <source>Show a mark, unhidden and without glare; check that the target is the one that carries them.</source>
        <translation>Zeigen Sie eine Marke, unverdeckt und ohne Glanzlicht; prüfen Sie, dass es der Zielkörper ist, der sie trägt.</translation>
    </message>
    <message>
        <source>No boxes that stand like the target&apos;s %1 boxes are found among %2 quadrilaterals.</source>
        <translation>Unter %2 Vierecken stehen keine Kästchen wie die %1 des Zielkörpers.</translation>
    </message>
    <message>
        <source>Show more of the target, evenly lit, within 45 degrees of upright.</source>
        <translation>Zeigen Sie mehr vom Zielkörper, gleichmäßig beleuchtet, bis 45 Grad gegen aufrecht.</translation>
    </message>
    <message>
        <source>Which of the target&apos;s %1 boxes the %2 found are can&apos;t be told for certain.</source>
        <translation>Welche der %1 Kästchen des Zielkörpers die %2 gefundenen sind, ist nicht sicher zu sagen.</translation>
    </message>
    <message>
        <source>Show boxes of the top and the bottom row, and of the first and the last column.</source>
        <translation>Zeigen Sie Kästchen der obersten und untersten Zeile und der ersten und letzten Spalte.</translation>
    </message>
    <message>
        <source>Show boxes of the top and the bottom row, and of both planes.</source>
        <translation>Zeigen Sie Kästchen der obersten und untersten Zeile und beider Ebenen.</translation>
    </message>
    <message>
        <source>No chessboard of %1 x %2 inner corners is found.</source>
        <translation>Kein Schachbrett mit %1 x %2 inneren Ecken ist gefunden.</translation>
    </message>
    <message>
        <source>Show the whole board with a white margin, evenly lit, and check the numbers of corners.</source>
        <translation>Zeigen Sie das ganze Brett mit weißem Rand, gleichmäßig beleuchtet, und prüfen Sie die Zahl der Ecken.</translation>
    </message>
    <message>
        <source>The chessboard is too small in the picture: its corners are %1 px apart.</source>
        <translation>Das Schachbrett ist im Bild zu klein: Seine Ecken liegen %1 px auseinander.</translation>
    </message>
    <message>
        <source>Bring it nearer.</source>
        <translation>Bringen Sie es näher.</translation>
    </message>
    <message>
        <source>The chessboard&apos;s corners are too blurred to be measured.</source>
        <translation>Die Ecken des Schachbretts sind zu unscharf, um sie zu messen.</translation>
    </message>
    <message>
        <source>Hold it still and focus.</source>
        <translation>Halten Sie es still und stellen Sie scharf.</translation>
    </message>
    <message>
        <source>No marker of the ChArUco board is found.</source>
        <translation>Keine Marke der ChArUco-Tafel ist gefunden.</translation>
    </message>
    <message>
        <source>Show the board larger and evenly lit, and check its dictionary.</source>
        <translation>Zeigen Sie die Tafel größer und gleichmäßig beleuchtet, und prüfen Sie ihr Verzeichnis.</translation>
    </message>
    <message>
        <source>Only %1 corners of the ChArUco board are found.</source>
        <translation>Nur %1 Ecken der ChArUco-Tafel sind gefunden.</translation>
    </message>
    <message>
        <source>Show more of the board: six corners that are not all in a row.</source>
        <translation>Zeigen Sie mehr von der Tafel: sechs Ecken, die nicht alle in einer Reihe liegen.</translation>
    </message>
    <message>
        <source>There is no marker dictionary &quot;%1&quot;.</source>
        <translation>Es gibt kein Markenverzeichnis „%1“.</translation>
    </message>
    <message>
        <source>Name one of OpenCV&apos;s, for example DICT_6X6_250.</source>
        <translation>Nennen Sie eines von OpenCV, zum Beispiel DICT_6X6_250.</translation>
    </message>
    <message>
        <source>A target of %1 can&apos;t be found in pictures.</source>
        <translation>Ein Zielkörper aus %1 ist in Bildern nicht zu finden.</translation>
    </message>
    <message>
        <source>Use boxes, a chessboard or a ChArUco board.</source>
        <translation>Verwenden Sie Kästchen, ein Schachbrett oder eine ChArUco-Tafel.</translation>
    </message>
    <message>
        <source>The target &quot;%1&quot; can&apos;t be used: %2.</source>
        <translation>Der Zielkörper „%1“ ist nicht brauchbar: %2.</translation>
    </message>
    <message>
        <source>Give the numbers of the printed board.</source>
        <translation>Geben Sie die Zahlen der gedruckten Tafel an.</translation>
    </message>
    <message>
        <source>The target &quot;%1&quot; is not one this program knows.</source>
        <translation>Den Zielkörper „%1“ kennt dieses Programm nicht.</translation>
    </message>
    <message>
        <source>Give a target file (.yaml), chessboard:9x6:30 (inner corners across x down, square in mm), charuco:5x7:40:20:DICT_6X6_250 (squares across x down, square, marker, dictionary) or two-plane-24.</source>
        <translation>Geben Sie eine Zielkörperdatei (.yaml) an, chessboard:9x6:30 (innere Ecken waagrecht x senkrecht, Feld in mm), charuco:5x7:40:20:DICT_6X6_250 (Felder waagrecht x senkrecht, Feld, Marke, Verzeichnis) oder two-plane-24.</translation>
    </message>
    <message>
        <source>it needs 3 to 100 inner corners each way and a square of up to 10000 mm</source>
        <translation>nötig sind 3 bis 100 innere Ecken in jeder Richtung und ein Feld bis 10000 mm</translation>
    </message>
    <message>
        <source>it needs 3 to 100 squares each way and a square of up to 10000 mm</source>
        <translation>nötig sind 3 bis 100 Felder in jeder Richtung und ein Feld bis 10000 mm</translation>
    </message>
    <message>
        <source>its marker is not smaller than its square</source>
        <translation>seine Marke ist nicht kleiner als sein Feld</translation>
    </message>
    <message>
        <source>its dictionary has only %1 markers</source>
        <translation>sein Verzeichnis hat nur %1 Marken</translation>
    </message>
    <message>
        <source>there is no marker dictionary &quot;%1&quot;</source>
        <translation>es gibt kein Markenverzeichnis „%1“</translation>
    </message>
    <message>
        <source>it needs 1 to 16 planes and 1 to 100 rows</source>
        <translation>nötig sind 1 bis 16 Ebenen und 1 bis 100 Zeilen</translation>
    </message>
    <message>
        <source>its boxes touch each other: a pitch is larger than the box</source>
        <translation>seine Kästchen berühren sich: Ein Rastermaß ist größer als das Kästchen</translation>
    </message>
    <message>
        <source>The target file&apos;s %1.</source>
        <translation>Die Zielkörperdatei: %1.</translation>
    </message>
    <message>
        <source>Mend the file, or start from one of those in resources/targets.</source>
        <translation>Berichtigen Sie die Datei, oder gehen Sie von einer aus resources/targets aus.</translation>
    </message>
    <message>
        <source>A mark of the target does not lie on its sheet.</source>
        <translation>Eine Marke des Zielkörpers liegt nicht auf ihrem Blatt.</translation>
    </message>
    <message>
        <source>Move the mark in the target file, or give the target a wider margin_mm.</source>
        <translation>Verschieben Sie die Marke in der Zielkörperdatei, oder geben Sie dem Zielkörper ein größeres margin_mm.</translation>
    </message>
    <message>
        <source>The target&apos;s points can&apos;t be printed: some lie on no plane with three others or more.</source>
        <translation>Die Punkte des Zielkörpers sind nicht zu drucken: Einige liegen auf keiner Ebene mit drei anderen oder mehr.</translation>
    </message>
    <message>
        <source>Print targets whose points stand on up to 16 planes.</source>
        <translation>Drucken Sie Zielkörper, deren Punkte auf bis zu 16 Ebenen stehen.</translation>
    </message>
    <message>
        <source>A sheet of %1 with its ruler does not fit on %2 (%3) at its true size.</source>
        <translation>Ein Blatt von %1 mit seinem Maßstab passt in wahrer Größe nicht auf %2 (%3).</translation>
    </message>
    <message>
        <source>what was found in the right picture leads back to another place</source>
        <translation>was im rechten Bild gefunden wurde, führt an eine andere Stelle zurück</translation>
    </message>
    <message>
        <source>what looks like it is farther away than it can have gone</source>
        <translation>was so aussieht, ist weiter weg, als es gelangt sein kann</translation>
    </message>
    <message>
        <source>The head was halted: nobody said any more that it is to go on turning.</source>
        <translation>Der Kopf wurde angehalten: niemand sagte mehr, dass er sich weiterdrehen soll.</translation>
    </message>
    <message>
        <source>The head can&apos;t be turned at a speed.</source>
        <translation>Der Kopf kennt kein Drehen mit einer Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The head can&apos;t be reset.</source>
        <translation>Der Kopf lässt sich nicht zurücksetzen.</translation>
    </message>
    <message>
        <source>The head has no zoom.</source>
        <translation>Der Kopf hat keinen Zoom.</translation>
    </message>
    <message>
        <source>The head has no focus.</source>
        <translation>Der Kopf hat keinen verstellbaren Fokus.</translation>
    </message>
    <message>
        <source>The head has no autofocus.</source>
        <translation>Der Kopf hat keinen Autofokus.</translation>
    </message>
    <message>
        <source>The head has no presets.</source>
        <translation>Der Kopf hat keine Speicher.</translation>
    </message>
    <message>
        <source>Use another head.</source>
        <translation>Benutzen Sie einen anderen Kopf.</translation>
    </message>
    <message>
        <source>There is no preset %1.</source>
        <translation>Es gibt keinen Speicher %1.</translation>
    </message>
    <message>
        <source>Give a number from %1 to %2.</source>
        <translation>Geben Sie eine Zahl von %1 bis %2 an.</translation>
    </message>
    <message>
        <source>Nothing is seen at that place of the pan-tilt picture.</source>
        <translation>An dieser Stelle im Bild der Schwenkkamera ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose one nearer to its middle.</source>
        <translation>Wählen Sie eine näher an seiner Mitte.</translation>
    </message>
    <message>
        <source>Calibrate it with the others first.</source>
        <translation>Kalibrieren Sie sie zuerst mit den anderen.</translation>
    </message>
    <message>
        <source>The target was not moved along a line.</source>
        <translation>Das Ziel wurde nicht entlang einer Geraden bewegt.</translation>
    </message>
    <message>
        <source>Move it straight up or down, as on a plumb line, and nothing else.</source>
        <translation>Bewegen Sie es gerade auf und ab, wie an einem Lot, und sonst nichts.</translation>
    </message>
    <message>
        <source>The movement is far from upright in the pictures.</source>
        <translation>Die Bewegung ist in den Bildern weit von der Senkrechten entfernt.</translation>
    </message>
    <message>
        <source>Move the target up and down, not across or away; a rig that looks down by more than 60 degrees can&apos;t be levelled so.</source>
        <translation>Bewegen Sie das Ziel auf und ab, nicht zur Seite oder weg; eine Anlage, die mehr als 60 Grad nach unten blickt, lässt sich so nicht ausrichten.</translation>
    </message>
    <message>
        <source>The points do not lie spread over a plane.</source>
        <translation>Die Punkte liegen nicht über eine Ebene verteilt.</translation>
    </message>
    <message>
        <source>Measure points all over a flat, upright wall.</source>
        <translation>Messen Sie Punkte überall auf einer ebenen, senkrechten Wand.</translation>
    </message>
    <message>
        <source>The wall is seen too much from its side.</source>
        <translation>Die Wand wird zu sehr von der Seite gesehen.</translation>
    </message>
    <message>
        <source>Stand the rig before the wall, looking at it.</source>
        <translation>Stellen Sie die Anlage vor die Wand, mit Blick auf sie.</translation>
    </message>
    <message>
        <source>The points scatter so much that the mount&apos;s angle is known to %1 degrees only.</source>
        <translation>Die Punkte streuen so sehr, dass der Einbauwinkel nur auf %1 Grad bekannt ist.</translation>
    </message>
    <message>
        <source>Measure more points, over more height, nearer to the rig.</source>
        <translation>Messen Sie mehr Punkte, über mehr Höhe, näher an der Anlage.</translation>
    </message>
    <message>
        <source>%1 points are too few to level by.</source>
        <translation>%1 Punkte sind zu wenige zum Ausrichten.</translation>
    </message>
    <message>
        <source>Station %1 %2.</source>
        <translation>Ort %1 %2.</translation>
    </message>
    <message>
        <source>was measured behind the left camera</source>
        <translation>wurde hinter der linken Kamera gemessen</translation>
    </message>
    <message>
        <source>has a coordinate that is no number</source>
        <translation>hat eine Koordinate, die keine Zahl ist</translation>
    </message>
    <message>
        <source>has a known place that is not before the left camera</source>
        <translation>hat einen bekannten Ort, der nicht vor der linken Kamera liegt</translation>
    </message>
    <message>
        <source>Leave it out, or mend the tables of known places and of measured positions.</source>
        <translation>Lassen Sie ihn weg, oder berichtigen Sie die Tabellen der bekannten Orte und der gemessenen Positionen.</translation>
    </message>
    <message>
        <source>The known places do not fix where their frame lies.</source>
        <translation>Die bekannten Orte legen nicht fest, wo ihr Koordinatensystem liegt.</translation>
    </message>
    <message>
        <source>Give four or more that are not on one line, or give them in the rig&apos;s or the left camera&apos;s frame.</source>
        <translation>Geben Sie vier oder mehr an, die nicht auf einer Geraden liegen, oder geben Sie sie im Koordinatensystem der Anlage oder der linken Kamera an.</translation>
    </message>
    <message>
        <source>The rig file holds no pan-tilt camera.</source>
        <translation>Die Kalibrierdatei enthält keine Schwenkkamera.</translation>
    </message>
    <message>
        <source>Calibrate all three cameras with the head at home first.</source>
        <translation>Kalibrieren Sie zuerst alle drei Kameras, den Kopf in Grundstellung.</translation>
    </message>
    <message>
        <source>%1 views are too few to calibrate the head.</source>
        <translation>%1 Ansichten sind zu wenige, um den Kopf zu kalibrieren.</translation>
    </message>
    <message>
        <source>Give at least %1, over the whole range of pan and tilt that the target allows.</source>
        <translation>Geben Sie mindestens %1 an, über den ganzen Bereich von Schwenken und Neigen, den der Zielkörper erlaubt.</translation>
    </message>
    <message>
        <source>The head&apos;s positions lie too near together to tell its axes.</source>
        <translation>Die Stellungen des Kopfes liegen zu nah beieinander, um seine Achsen zu bestimmen.</translation>
    </message>
    <message>
        <source>Spread them over at least 20 degrees of pan and 10 degrees of tilt.</source>
        <translation>Verteilen Sie sie über mindestens 20 Grad Schwenken und 10 Grad Neigen.</translation>
    </message>
    <message>
        <source>A point lies where the pan-tilt camera can&apos;t see it.</source>
        <translation>Ein Punkt liegt, wo die Schwenkkamera ihn nicht sehen kann.</translation>
    </message>
    <message>
        <source>Check the signs of the angles (pan to the right, tilt upwards) and the pan-tilt camera&apos;s pose in the rig file.</source>
        <translation>Prüfen Sie die Vorzeichen der Winkel (Schwenken nach rechts, Neigen nach oben) und die Lage der Schwenkkamera in der Kalibrierdatei.</translation>
    </message>
    <message>
        <source>The views don&apos;t fit a head of two axes: RMS %1 px.</source>
        <translation>Die Ansichten passen nicht zu einem Kopf mit zwei Achsen: RMS %1 px.</translation>
    </message>
    <message>
        <source>Check that each picture stands beside the angles it was taken at, the head still, and that pan is positive to the right and tilt upwards.</source>
        <translation>Prüfen Sie, dass jedes Bild bei den Winkeln steht, bei denen es aufgenommen wurde, der Kopf ruhte, und dass Schwenken nach rechts und Neigen nach oben positiv ist.</translation>
    </message>
    <message>
        <source>The %1 picture is not of the size that the rig was calibrated for.</source>
        <translation>Das Bild der Kamera %1 hat nicht die Größe, für die die Anlage kalibriert wurde.</translation>
    </message>
    <message>
        <source>Give pictures of that size.</source>
        <translation>Geben Sie Bilder dieser Größe.</translation>
    </message>
    <message>
        <source>The left and the right picture share only %1 corners of the target.</source>
        <translation>Das linke und das rechte Bild haben nur %1 Ecken des Zielkörpers gemeinsam.</translation>
    </message>
    <message>
        <source>Show it to both.</source>
        <translation>Zeigen Sie ihn beiden.</translation>
    </message>
    <message>
        <source>A picture of the three cameras is missing.</source>
        <translation>Ein Bild der drei Kameras fehlt.</translation>
    </message>
    <message>
        <source>Check that all three deliver pictures.</source>
        <translation>Prüfen Sie, dass alle drei Bilder liefern.</translation>
    </message>
    <message>
        <source>The head&apos;s camera sees too few of the target&apos;s corners.</source>
        <translation>Die Kamera des Kopfes sieht zu wenige Ecken des Zielkörpers.</translation>
    </message>
    <message>
        <source>Turn the head towards it.</source>
        <translation>Drehen Sie den Kopf zu ihm.</translation>
    </message>
    <message>
        <source>pan_deg and tilt_deg are not two numbers.</source>
        <translation>pan_deg und tilt_deg sind nicht zwei Zahlen.</translation>
    </message>
    <message>
        <source>%1 has no column %2.</source>
        <translation>%1 hat keine Spalte %2.</translation>
    </message>
    <message>
        <source>Name the columns in its first line, separated by commas.</source>
        <translation>Nennen Sie die Spalten in der ersten Zeile, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>%1 holds no rows.</source>
        <translation>%1 enthält keine Zeilen.</translation>
    </message>
    <message>
        <source>Write one line for each.</source>
        <translation>Schreiben Sie für jeden eine Zeile.</translation>
    </message>
    <message>
        <source>Line %1 of %2 holds no place.</source>
        <translation>Zeile %1 von %2 enthält keinen Ort.</translation>
    </message>
    <message>
        <source>Give every place three numbers: x_mm, y_mm, z_mm.</source>
        <translation>Geben Sie jedem Ort drei Zahlen: x_mm, y_mm, z_mm.</translation>
    </message>
    <message>
        <source>Give at least %1.</source>
        <translation>Geben Sie mindestens %1 an.</translation>
    </message>
    <message>
        <source>Nothing was kept in preset %1.</source>
        <translation>Unter Nummer %1 ist nichts gemerkt.</translation>
    </message>
    <message>
        <source>Keep a position in it first.</source>
        <translation>Merken Sie erst eine Stellung darin.</translation>
    </message>
    <message>
        <source>The baseline that suits the known places best is %1 mm, the rig&apos;s is %2 mm, and the range error is %3 % in the mean: that is no wrong baseline.</source>
        <translation>Die Basislänge, die am besten zu den bekannten Orten passt, ist %1 mm, die der Anlage %2 mm, und der Entfernungsfehler beträgt im Mittel %3 %: Das ist keine falsche Basislänge.</translation>
    </message>
    <message>
        <source>Check the known places, their frame and their unit, and that the target that was followed stood there; or give the baseline measured by tape.</source>
        <translation>Prüfen Sie die bekannten Orte, ihr Koordinatensystem und ihre Einheit, und ob das verfolgte Ziel dort stand; oder geben Sie die mit dem Bandmaß gemessene Basislänge an.</translation>
    </message>
    <message>
        <source>From zoom %1 to %2 the %3 points found again fit no zoom.</source>
        <translation>Von Zoom %1 bis %2 passen die %3 wiedergefundenen Punkte zu keinem Zoom.</translation>
    </message>
    <message>
        <source>From zoom %1 to %2 only %3 points are found again.</source>
        <translation>Von Zoom %1 bis %2 sind nur %3 Punkte wiedergefunden.</translation>
    </message>
    <message>
        <source>Take more views between these, of a scene at rest with much detail, in focus, the head at rest as well.</source>
        <translation>Nehmen Sie mehr Ansichten dazwischen auf, von einer ruhenden, scharfen Szene mit vielen Einzelheiten, auch der Kopf in Ruhe.</translation>
    </message>
    <message>
        <source>The view at zoom %1 has %2 x %3 pixels, the camera %4 x %5.</source>
        <translation>Die Ansicht bei Zoom %1 hat %2 x %3 Bildpunkte, die Kamera %4 x %5.</translation>
    </message>
    <message>
        <source>Use the rig file of the camera that took the views.</source>
        <translation>Nehmen Sie die Kalibrierdatei der Kamera, die die Ansichten aufnahm.</translation>
    </message>
    <message>
        <source>Two views are at the same zoom, %1.</source>
        <translation>Zwei Ansichten stehen bei demselben Zoom, %1.</translation>
    </message>
    <message>
        <source>Leave one of them out.</source>
        <translation>Lassen Sie eine davon weg.</translation>
    </message>
    <message>
        <source>The lens of the head &quot;%1&quot; at its widest is not known.</source>
        <translation>Das Objektiv des Kopfes &quot;%1&quot; in weitester Stellung ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Tell its focal length and its sensor&apos;s width, mm (--widest F,WIDTH).</source>
        <translation>Nennen Sie seine Brennweite und die Breite des Sensors, mm (--widest F,WIDTH).</translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation>Speichern Sie unter einem anderen Namen.</translation>
    </message>
</context>
<context>
    <name>kambara::CommandLine</name>
    <message>
        <source>Stereo vision for underwater vehicles. Without options: the simulated rig.</source>
        <translation>Stereosehen für Unterwasserfahrzeuge. Ohne Optionen: die simulierte Anlage.</translation>
    </message>
    <message>
        <source>SOURCE</source>
        <translation>QUELLE</translation>
    </message>
    <message>
        <source>Left pictures: a video, a pattern, or sim:PROFILE.</source>
        <translation>Linke Bilder: ein Video, ein Muster oder sim:PROFIL.</translation>
    </message>
    <message>
        <source>Right pictures.</source>
        <translation>Rechte Bilder.</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>DATEI</translation>
    </message>
    <message>
        <source>The rig file of these pictures.</source>
        <translation>Die Kalibrierdatei dieser Bilder.</translation>
    </message>
    <message>
        <source>HZ</source>
        <translation>HZ</translation>
    </message>
    <message>
        <source>Rate of single pictures (10 Hz unless given).</source>
        <translation>Rate von Einzelbildern (ohne Angabe 10 Hz).</translation>
    </message>
    <message>
        <source>CODE</source>
        <translation>CODE</translation>
    </message>
    <message>
        <source>Language of the window, such as de or en.</source>
        <translation>Sprache des Fensters, etwa de oder en.</translation>
    </message>
    <message>
        <source>Without the 3-D view.</source>
        <translation>Ohne die 3-D-Ansicht.</translation>
    </message>
    <message>
        <source>%1 is not understood: sources are named with --left and --right. See --help.</source>
        <translation>%1 ist unverständlich: Quellen werden mit --left und --right genannt. Siehe --help.</translation>
    </message>
    <message>
        <source>The left camera&apos;s pictures are missing: name them with --left.</source>
        <translation>Die Bilder der linken Kamera fehlen: nennen Sie sie mit --left.</translation>
    </message>
    <message>
        <source>--rate %1 is no rate: give a number of pictures a second, 0.1 to 1000.</source>
        <translation>--rate %1 ist keine Rate: geben Sie eine Zahl von Bildern in der Sekunde an, 0.1 bis 1000.</translation>
    </message>
    <message>
        <source>HEAD</source>
        <translation>KOPF</translation>
    </message>
    <message>
        <source>A real pan-tilt head: visca:/dev/ttyS0, visca-udp:HOST or visca-tcp:HOST.</source>
        <translation>Ein wirklicher Schwenk-Neige-Kopf: visca:/dev/ttyS0, visca-udp:RECHNER oder visca-tcp:RECHNER.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::About</name>
    <message>
        <source>Stereo vision for underwater vehicles: calibrate, track, position, point.</source>
        <translation>Stereosehen für Unterwasserfahrzeuge: kalibrieren, verfolgen, vermessen, zielen.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder später. Sie kommt ohne jede Gewähr.</translation>
    </message>
    <message>
        <source>It runs on %1.</source>
        <translation>Sie läuft mit %1.</translation>
    </message>
    <message>
        <source>About Kambara</source>
        <translation>Über Kambara</translation>
    </message>
</context>
<context>
    <name>kambara::ui::AssistantWindow</name>
    <message>
        <source>Close without saving</source>
        <translation>Ohne Speichern schließen</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this form; the target is followed on.  [Ctrl+W]</source>
        <translation>Schließt dieses Formular; das Ziel wird weiter verfolgt.  [Strg+W]</translation>
    </message>
    <message>
        <source>The simulated rig is opened anew for this. What runs now ends, and its targets are forgotten.</source>
        <translation>Dafür wird die simulierte Anlage neu geöffnet. Was jetzt läuft, endet, und seine Ziele werden vergessen.</translation>
    </message>
    <message>
        <source>Open the simulated rig</source>
        <translation>Simulierte Anlage öffnen</translation>
    </message>
</context>
<context>
    <name>kambara::ui::CalibrationWindow</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>The folder %1 can&apos;t be made. Choose a place that can be written to.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden. Wählen Sie einen Ort, an dem geschrieben werden darf.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::CapturePage</name>
    <message>
        <source>Without its tick a shot is dropped: it takes no part, but is not lost</source>
        <translation>Ohne Häkchen ist eine Aufnahme verworfen: Sie zählt nicht mit, geht aber nicht verloren</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Take now</source>
        <translation>&amp;Aufnehmen</translation>
    </message>
    <message>
        <source>Takes a shot without waiting for stillness</source>
        <translation>Nimmt auf, ohne auf Ruhe zu warten</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Takes no more shots until pressed again</source>
        <translation>Nimmt nichts mehr auf, bis wieder gedrückt wird</translation>
    </message>
    <message>
        <source>Simulated target</source>
        <translation>Simulierter Zielkörper</translation>
    </message>
    <message>
        <source>A helper follows the outline</source>
        <translation>Ein Helfer folgt dem Umriss</translation>
    </message>
    <message>
        <source>Off: hold the target yourself</source>
        <translation>Aus: Halten Sie den Zielkörper selbst</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>&amp;Kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Leave</source>
        <translation>&amp;Verlassen</translation>
    </message>
    <message>
        <source>Back to the choices; everything taken is kept in the folder</source>
        <translation>Zurück zur Auswahl; alles Aufgenommene bleibt im Ordner</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Waiting for pictures…</source>
        <translation>Warten auf Bilder …</translation>
    </message>
    <message>
        <source>No shot yet; about %1 are enough.</source>
        <translation>Noch keine Aufnahme; etwa %1 reichen.</translation>
    </message>
    <message>
        <source>%1 of about %2 shots. Ranges would be off by %3 (one deviation).</source>
        <translation>%1 von etwa %2 Aufnahmen. Entfernungen wären um %3 falsch (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>Shot %1 taken. Now to the next outline.</source>
        <translation>Aufnahme %1 gemacht. Nun zum nächsten Umriss.</translation>
    </message>
    <message>
        <source>Enough shots: press Calibrate. More make it a little better.</source>
        <translation>Genug Aufnahmen: Drücken Sie Kalibrieren. Weitere machen es etwas besser.</translation>
    </message>
    <message>
        <source>No target found for a long time. Is it the one that was chosen? Hold it so that it fills a third of every picture, evenly lit.</source>
        <translation>Seit Langem kein Zielkörper gefunden. Ist es der gewählte? Halten Sie ihn so, dass er ein Drittel jedes Bildes füllt, gleichmäßig beleuchtet.</translation>
    </message>
    <message>
        <source>There is no place where all cameras see the whole target: take a smaller one, or fewer cameras.</source>
        <translation>Nirgends sehen alle Kameras den ganzen Zielkörper: Nehmen Sie einen kleineren oder weniger Kameras.</translation>
    </message>
    <message>
        <source>Bring the target to the blue outline in every picture and hold it still. %1</source>
        <translation>Bringen Sie den Zielkörper in jedem Bild auf den blauen Umriss und halten Sie ihn still. %1</translation>
    </message>
    <message>
        <source>Shot %1: %2 corners</source>
        <translation>Aufnahme %1: %2 Ecken</translation>
    </message>
    <message>
        <source>Takes the last dropping or keeping back</source>
        <translation>Nimmt das letzte Verwerfen oder Behalten zurück</translation>
    </message>
    <message>
        <source>No shot was dropped or kept by hand yet.</source>
        <translation>Noch wurde keine Aufnahme von Hand verworfen oder behalten.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Stops the calculation; the shots are kept</source>
        <translation>Hält die Berechnung an; die Aufnahmen bleiben</translation>
    </message>
    <message>
        <source>Calculates the cameras from the shots kept</source>
        <translation>Berechnet die Kameras aus den behaltenen Aufnahmen</translation>
    </message>
    <message>
        <source>At least %1 shots are needed.</source>
        <translation>Mindestens %1 Aufnahmen sind nötig.</translation>
    </message>
    <message>
        <source>%1 shots, which is enough. Ranges would be off by %2 (one deviation).</source>
        <translation>%1 Aufnahmen, das genügt. Entfernungen wären um %2 falsch (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>Shot %1 taken. That is enough: press Calibrate.</source>
        <translation>Aufnahme %1 gemacht. Das genügt: Drücken Sie „Kalibrieren“.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::CorrelationMapView</name>
    <message>
        <source>The target is lost; there is no search to show just now.</source>
        <translation>Das Ziel ist verloren; gerade gibt es keine Suche zu zeigen.</translation>
    </message>
    <message>
        <source>No search yet. Choose a target in the left picture.</source>
        <translation>Noch keine Suche. Wählen Sie ein Ziel im linken Bild.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::CoveragePlot</name>
    <message>
        <source>Depths and angles covered</source>
        <translation>Abgedeckte Tiefen und Winkel</translation>
    </message>
    <message>
        <source>Turned and tilted</source>
        <translation>Gedreht und geneigt</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>No shot yet</source>
        <translation>Noch keine Aufnahme</translation>
    </message>
</context>
<context>
    <name>kambara::ui::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>kambara::ui::GuideView</name>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Pan-tilt</source>
        <translation>Schwenkkamera</translation>
    </message>
    <message>
        <source>%1: no picture yet</source>
        <translation>%1: noch kein Bild</translation>
    </message>
    <message>
        <source>%1 covered</source>
        <translation>%1 abgedeckt</translation>
    </message>
    <message>
        <source>%1 corners found</source>
        <translation>%1 Ecken gefunden</translation>
    </message>
</context>
<context>
    <name>kambara::ui::HeadStick</name>
    <message>
        <source>Stick</source>
        <translation>Steuerknüppel</translation>
    </message>
    <message>
        <source>Press and hold to turn the head: the farther from the middle, the faster. The arrow keys do the same.</source>
        <translation>Drücken und halten dreht den Kopf: je weiter von der Mitte, desto schneller. Die Pfeiltasten tun dasselbe.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::HeadWindow</name>
    <message>
        <source>The views so far were recorded with another rig. Clear them first.</source>
        <translation>Die bisherigen Ansichten wurden mit einer anderen Anlage aufgenommen. Löschen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>The rig in use does not hold all three cameras: open the source with the rig file that belongs to the record.</source>
        <translation>Die benutzte Anlage hat nicht alle drei Kameras: Öffnen Sie die Quelle mit der Kalibrierdatei, die zur Aufzeichnung gehört.</translation>
    </message>
    <message>
        <source>Looking for the target in the record&apos;s pictures…</source>
        <translation>Der Zielkörper wird in den Bildern der Aufzeichnung gesucht …</translation>
    </message>
    <message>
        <source>Views read: %1.</source>
        <translation>Gelesene Ansichten: %1.</translation>
    </message>
    <message>
        <source>Of no use: %1 rows; the first: %2</source>
        <translation>Unbrauchbar: %1 Zeilen; die erste: %2</translation>
    </message>
    <message>
        <source>below</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>above</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>Es wird gerechnet …</translation>
    </message>
    <message>
        <source>Solve first: there is no model to save.</source>
        <translation>Rechnen Sie zuerst: Es gibt kein Modell zu speichern.</translation>
    </message>
    <message>
        <source>No model yet: it takes 8 views, over 20° of pan and 10° of tilt.</source>
        <translation>Noch kein Modell: Es braucht 8 Ansichten, über 20° Schwenken und 10° Neigen.</translation>
    </message>
    <message>
        <source>%1 views, %2 points</source>
        <translation>%1 Ansichten, %2 Punkte</translation>
    </message>
    <message>
        <source>not measured: no views from both sides</source>
        <translation>nicht gemessen: keine Ansichten von beiden Seiten</translation>
    </message>
    <message>
        <source>Saved: %1. Open the source with this rig file to steer by it.</source>
        <translation>Gespeichert: %1. Öffnen Sie die Quelle mit dieser Kalibrierdatei, um danach zu steuern.</translation>
    </message>
    <message>
        <source>Saved: %1. calibrate-head --views reads it, too.</source>
        <translation>Gespeichert: %1. Auch calibrate-head --views liest sie.</translation>
    </message>
    <message>
        <source>Head calibration</source>
        <translation>Kalibrierung des Kopfs</translation>
    </message>
    <message>
        <source>Record of head views</source>
        <translation>Aufzeichnung von Ansichten des Kopfs</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Clear without saving</source>
        <translation>Ohne Speichern löschen</translation>
    </message>
    <message>
        <source>Another source was opened: recording ended.</source>
        <translation>Eine andere Quelle wurde geöffnet: Die Aufzeichnung ist beendet.</translation>
    </message>
    <message>
        <source>No source is open: open one in the main window.</source>
        <translation>Keine Quelle ist offen: Öffnen Sie eine im Hauptfenster.</translation>
    </message>
    <message>
        <source>The rig in use does not hold all three cameras: calibrate them first, with the head at home (Calibration &gt; Calibrate).</source>
        <translation>Die benutzte Anlage hat nicht alle drei Kameras: Kalibrieren Sie sie zuerst, den Kopf in Grundstellung (Kalibrierung &gt; Kalibrieren).</translation>
    </message>
    <message>
        <source>This source has no pan-tilt head: a record of the command line&apos;s can be loaded.</source>
        <translation>Diese Quelle hat keinen Schwenkkopf: Eine Aufzeichnung der Befehlszeile kann geladen werden.</translation>
    </message>
    <message>
        <source>The head&apos;s camera delivers no pictures: a record can be loaded instead.</source>
        <translation>Die Kamera des Kopfs liefert keine Bilder: Stattdessen kann eine Aufzeichnung geladen werden.</translation>
    </message>
    <message>
        <source>The simulated rig is being opened with this target…</source>
        <translation>Die simulierte Anlage wird mit diesem Zielkörper geöffnet …</translation>
    </message>
    <message>
        <source>The head looks at pan %1, tilt %2.</source>
        <translation>Der Kopf blickt nach Schwenken %1, Neigen %2.</translation>
    </message>
    <message>
        <source>Position %1 of %2.</source>
        <translation>Stellung %1 von %2.</translation>
    </message>
    <message>
        <source>Looking for the target in the left and the right picture…</source>
        <translation>Der Zielkörper wird im linken und im rechten Bild gesucht …</translation>
    </message>
    <message>
        <source>The target is seen. Hold it still…</source>
        <translation>Der Zielkörper ist gefunden. Halten Sie ihn still …</translation>
    </message>
    <message>
        <source>The target stands too far to the side for the head to turn about it. Put it nearer to the middle.</source>
        <translation>Der Zielkörper steht zu weit seitlich, als dass der Kopf sich um ihn drehen könnte. Stellen Sie ihn näher zur Mitte.</translation>
    </message>
    <message>
        <source>The head goes to %1 positions. Keep the target still; F12 stops the head.</source>
        <translation>Der Kopf geht in %1 Stellungen. Lassen Sie den Zielkörper stehen; F12 hält den Kopf an.</translation>
    </message>
    <message>
        <source>The head was stopped or moved by other means: the round ended. What was recorded is kept.</source>
        <translation>Der Kopf wurde anderweitig angehalten oder bewegt: Die Runde ist beendet. Was aufgezeichnet wurde, bleibt.</translation>
    </message>
    <message>
        <source>The head did not get to pan %1, tilt %2 within 15 seconds. Check its line and that nothing blocks it, then go on.</source>
        <translation>Der Kopf kam nicht innerhalb von 15 Sekunden nach Schwenken %1, Neigen %2. Prüfen Sie seine Leitung und dass nichts ihn hindert, dann fahren Sie fort.</translation>
    </message>
    <message>
        <source>The head&apos;s model that was found has not been saved.</source>
        <translation>Das gefundene Modell des Kopfs ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>The recorded views have not been saved.</source>
        <translation>Die aufgezeichneten Ansichten sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>Record of the &amp;views</source>
        <translation>Aufzeichnung der &amp;Ansichten</translation>
    </message>
    <message>
        <source>Save r&amp;ecord</source>
        <translation>Auf&amp;zeichnung speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Rig &amp;file</source>
        <translation>Kalibrier&amp;datei</translation>
    </message>
    <message>
        <source>&amp;Save rig</source>
        <translation>Anlage &amp;speichern</translation>
    </message>
    <message>
        <source>Rig files (*.yaml)</source>
        <translation>Kalibrierdateien (*.yaml)</translation>
    </message>
    <message>
        <source>A target&apos;s short form, or its file (.yaml)</source>
        <translation>Die Kurzform eines Zielkörpers oder seine Datei (.yaml)</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>&amp;Zielkörper</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>came from, pan / tilt</source>
        <translation>kam von, Schw. / Neig.</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>why it is of no use</source>
        <translation>warum unbrauchbar</translation>
    </message>
    <message>
        <source>Recorded views</source>
        <translation>Aufgezeichnete Ansichten</translation>
    </message>
    <message>
        <source>There are no views yet.

Stand the target about a metre before the rig, where all three cameras see it, and go through the positions: the head turns about it by itself, and each one is come to from below and from above, which tells the backlash.

For still better lever arms, move the target and go through them again. Or load a record of the command line&apos;s calibrate-head.</source>
        <translation>Es gibt noch keine Ansichten.

Stellen Sie den Zielkörper etwa einen Meter vor die Anlage, wo alle drei Kameras ihn sehen, und fahren Sie die Stellungen ab: Der Kopf dreht sich von selbst um ihn, und jede wird von unten und von oben erreicht, was das Spiel verrät.

Für noch bessere Hebelarme versetzen Sie den Zielkörper und fahren sie noch einmal ab. Oder laden Sie eine Aufzeichnung für calibrate-head von der Befehlszeile.</translation>
    </message>
    <message>
        <source>&amp;Go through the positions</source>
        <translation>Stellungen ab&amp;fahren</translation>
    </message>
    <message>
        <source>&amp;Record this view</source>
        <translation>Diese Ansicht auf&amp;zeichnen</translation>
    </message>
    <message>
        <source>&amp;Load a record…</source>
        <translation>Aufzeichnung &amp;laden …</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>S&amp;olve</source>
        <translation>&amp;Rechnen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>RMS over all points, in the head&apos;s picture.</source>
        <translation>Quadratisches Mittel über alle Punkte, im Bild des Kopfs.</translation>
    </message>
    <message>
        <source>as an angle</source>
        <translation>als Winkel</translation>
    </message>
    <message>
        <source>The same, at the head&apos;s camera.</source>
        <translation>Dasselbe, an der Kamera des Kopfs.</translation>
    </message>
    <message>
        <source>without a model</source>
        <translation>ohne Modell</translation>
    </message>
    <message>
        <source>If the camera turned about its own centre: what the model is worth.</source>
        <translation>Wenn sich die Kamera um ihr eigenes Zentrum drehte: was das Modell wert ist.</translation>
    </message>
    <message>
        <source>Tilt axis ahead</source>
        <translation>Neigeachse voraus</translation>
    </message>
    <message>
        <source>Of the pan axis; ± one standard deviation.</source>
        <translation>Vor der Schwenkachse; ± eine Standardabweichung.</translation>
    </message>
    <message>
        <source>Camera off tilt axis</source>
        <translation>Kamera neben Neigeachse</translation>
    </message>
    <message>
        <source>The tilt axis&apos;s place in the camera&apos;s frame; ± one standard deviation.</source>
        <translation>Ort der Neigeachse im Koordinatensystem der Kamera; ± eine Standardabweichung.</translation>
    </message>
    <message>
        <source>Tilt axis skew</source>
        <translation>Schiefe der Neigeachse</translation>
    </message>
    <message>
        <source>From square to the pan axis.</source>
        <translation>Gegen den rechten Winkel zur Schwenkachse.</translation>
    </message>
    <message>
        <source>Backlash of pan</source>
        <translation>Spiel beim Schwenken</translation>
    </message>
    <message>
        <source>By how much farther the encoder goes than the axis; ± one standard deviation.</source>
        <translation>Um wie viel der Geber weiter geht als die Achse; ± eine Standardabweichung.</translation>
    </message>
    <message>
        <source>Backlash of tilt</source>
        <translation>Spiel beim Neigen</translation>
    </message>
    <message>
        <source>Clear the views to take another target.</source>
        <translation>Löschen Sie die Ansichten, um einen anderen Zielkörper zu nehmen.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Where the head stands now; from which side it came is not known.</source>
        <translation>Wo der Kopf jetzt steht; von welcher Seite er kam, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>It takes %1 views.</source>
        <translation>Es braucht %1 Ansichten.</translation>
    </message>
    <message>
        <source>There are no recorded pictures.</source>
        <translation>Es gibt keine aufgezeichneten Bilder.</translation>
    </message>
    <message>
        <source>its own calibration took part; moved most: %1, by %2 of its deviations</source>
        <translation>ihre eigene Kalibrierung zählte mit; am meisten verschoben: %1, um das %2-Fache seiner Abweichung</translation>
    </message>
    <message>
        <source>held: it does not tell how well it is known</source>
        <translation>festgehalten: sie sagt nicht, wie genau sie bekannt ist</translation>
    </message>
    <message>
        <source>The rig</source>
        <translation>Die Anlage</translation>
    </message>
    <message>
        <source>Where its calibration took part, the deviations contain the rig&apos;s own error. It is saved as it is, with the head&apos;s numbers that steer best beside it; calibrate-head --refine-rig writes both as the views correct them.</source>
        <translation>Wo ihre Kalibrierung mitzählte, enthalten die Abweichungen auch ihren eigenen Fehler. Sie wird gespeichert, wie sie ist, mit den Zahlen des Kopfes, die neben ihr am besten steuern; calibrate-head --refine-rig schreibt beides so, wie die Ansichten es berichtigen.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::HoldPad</name>
    <message>
        <source>Hold the target</source>
        <translation>Den Zielkörper halten</translation>
    </message>
    <message>
        <source>Drag: move. Shift + drag: turn and tilt. Ctrl + drag: roll. Wheel: nearer and farther. Keys: arrows, with Shift or Ctrl as above; Page up and down</source>
        <translation>Ziehen: bewegen. Umschalt + Ziehen: drehen und neigen. Strg + Ziehen: rollen. Rad: näher und ferner. Tasten: Pfeile, mit Umschalt oder Strg wie oben; Bild auf und ab</translation>
    </message>
    <message>
        <source>Drag here to hold the target.
Shift: turn, wheel: nearer</source>
        <translation>Hier ziehen, um ihn zu halten.
Umschalt: drehen, Rad: näher</translation>
    </message>
    <message>
        <source>Nothing to hold yet</source>
        <translation>Noch nichts zu halten</translation>
    </message>
</context>
<context>
    <name>kambara::ui::Keys</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>kambara::ui::LensControls</name>
    <message>
        <source>Zoom out</source>
        <translation>Herauszoomen</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Hineinzoomen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Autofocus</source>
        <translation>Autofokus</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Merken</translation>
    </message>
    <message>
        <source>Recall</source>
        <translation>Aufrufen</translation>
    </message>
    <message>
        <source>There is no pan-tilt head.</source>
        <translation>Es gibt keinen Schwenkkopf.</translation>
    </message>
    <message>
        <source>This head has no zoom.</source>
        <translation>Dieser Kopf hat keinen Zoom.</translation>
    </message>
    <message>
        <source>From wide to tele</source>
        <translation>Von Weitwinkel bis Tele</translation>
    </message>
    <message>
        <source>Zooms out</source>
        <translation>Zoomt heraus</translation>
    </message>
    <message>
        <source>Zooms in</source>
        <translation>Zoomt hinein</translation>
    </message>
    <message>
        <source>From far to near; autofocus ends with it</source>
        <translation>Von fern bis nah; beendet den Autofokus</translation>
    </message>
    <message>
        <source>This head has no focus.</source>
        <translation>Dieser Kopf hat keinen verstellbaren Fokus.</translation>
    </message>
    <message>
        <source>The camera focuses by itself</source>
        <translation>Die Kamera stellt selbst scharf</translation>
    </message>
    <message>
        <source>This head has no autofocus.</source>
        <translation>Dieser Kopf hat keinen Autofokus.</translation>
    </message>
    <message>
        <source>This head has no presets.</source>
        <translation>Dieser Kopf hat keine Speicher.</translation>
    </message>
    <message>
        <source>Number of the preset</source>
        <translation>Nummer des Speichers</translation>
    </message>
    <message>
        <source>Keeps where the head looks, its zoom and focus</source>
        <translation>Merkt sich, wohin der Kopf blickt, seinen Zoom und Fokus</translation>
    </message>
    <message>
        <source>Goes back to what was kept under this number</source>
        <translation>Kehrt zu dem zurück, was unter dieser Nummer gemerkt ist</translation>
    </message>
    <message>
        <source>The head does not tell of its lens.</source>
        <translation>Der Kopf sagt nichts über sein Objektiv.</translation>
    </message>
    <message>
        <source>Magnification, and the angle of view across, in air</source>
        <translation>Vergrößerung und waagrechter Bildwinkel, in Luft</translation>
    </message>
    <message>
        <source>Share of the zoom&apos;s way; this lens&apos; angles are not known</source>
        <translation>Anteil des Zoomwegs; die Bildwinkel dieses Objektivs sind nicht bekannt</translation>
    </message>
</context>
<context>
    <name>kambara::ui::LevellingWindow</name>
    <message>
        <source>Levelling</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>A vertical movement</source>
        <translation>Eine senkrechte Bewegung</translation>
    </message>
    <message>
        <source>An upright wall</source>
        <translation>Eine senkrechte Wand</translation>
    </message>
    <message>
        <source>&amp;Level by</source>
        <translation>&amp;Ausrichten nach</translation>
    </message>
    <message>
        <source>A wall says nothing of roll. 0 where the rig hangs level from side to side.</source>
        <translation>Eine Wand sagt nichts über das Rollen. 0, wo die Anlage seitlich waagrecht hängt.</translation>
    </message>
    <message>
        <source>Roll, &amp;known</source>
        <translation>&amp;Rollen, bekannt</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Auf&amp;zeichnen</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>Recorded while the target was tracked.</source>
        <translation>Aufgezeichnet, während das Ziel verfolgt wurde.</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>The movement&apos;s length, or the wall&apos;s height as far as measured.</source>
        <translation>Die Länge der Bewegung oder die Höhe der Wand, soweit gemessen.</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Geradheit</translation>
    </message>
    <message>
        <source>RMS of the positions&apos; distances from the line or the plane.</source>
        <translation>Quadratisches Mittel der Abstände der Positionen von der Geraden oder der Ebene.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Positions that lie far off the others.</source>
        <translation>Positionen, die weit neben den anderen liegen.</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>By how much the rig looks down; ± one standard deviation.</source>
        <translation>Um wie viel die Anlage nach unten blickt; ± eine Standardabweichung.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>By how much the rig&apos;s right side hangs down; ± one standard deviation.</source>
        <translation>Um wie viel die rechte Seite der Anlage tiefer hängt; ± eine Standardabweichung.</translation>
    </message>
    <message>
        <source>Rig &amp;file</source>
        <translation>Kalibrier&amp;datei</translation>
    </message>
    <message>
        <source>&amp;Use this</source>
        <translation>&amp;Übernehmen</translation>
    </message>
    <message>
        <source>Rig files (*.yaml)</source>
        <translation>Kalibrierdateien (*.yaml)</translation>
    </message>
    <message>
        <source>Another source was opened: the recording ended.</source>
        <translation>Eine andere Quelle wurde geöffnet: Die Aufzeichnung ist beendet.</translation>
    </message>
    <message>
        <source>Stand the rig before a flat, upright wall. Choose a target on it and record; then move the vehicle or the target so that it goes all over the wall, up and down as well as to the sides.</source>
        <translation>Stellen Sie die Anlage vor eine ebene, senkrechte Wand. Wählen Sie ein Ziel darauf und zeichnen Sie auf; dann bewegen Sie das Fahrzeug oder das Ziel so, dass es über die ganze Wand geht, auf und ab wie auch zur Seite.</translation>
    </message>
    <message>
        <source>Track a target, record, then move it or the vehicle straight up and down, as on a plumb line, half a metre or more, and nothing else.</source>
        <translation>Verfolgen Sie ein Ziel, zeichnen Sie auf, dann bewegen Sie es oder das Fahrzeug gerade auf und ab, wie an einem Lot, einen halben Meter oder mehr, und sonst nichts.</translation>
    </message>
    <message>
        <source>The recorded positions appear here, seen from the front and from the side.</source>
        <translation>Hier erscheinen die aufgezeichneten Positionen, von vorn und von der Seite gesehen.</translation>
    </message>
    <message>
        <source>The recorded positions come from another rig. Clear them first.</source>
        <translation>Die aufgezeichneten Positionen stammen von einer anderen Anlage. Löschen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>The recording is full and has ended. Clear it to record anew.</source>
        <translation>Die Aufzeichnung ist voll und beendet. Löschen Sie sie, um neu aufzuzeichnen.</translation>
    </message>
    <message>
        <source>The movement is short: %1. Go on to %2 or more, since errors that hang together turn a short line by much.</source>
        <translation>Die Bewegung ist kurz: %1. Gehen Sie auf %2 oder mehr, denn zusammenhängende Fehler drehen eine kurze Gerade stark.</translation>
    </message>
    <message>
        <source>The positions are far from a plane: if that is a bend, it may have turned it by up to %1.</source>
        <translation>Die Positionen liegen weit von einer Ebene: Ist das eine Krümmung, so kann sie die Ebene um bis zu %1 gedreht haben.</translation>
    </message>
    <message>
        <source>The movement is crooked: a bend of that size may have turned it by up to %1. Move straight up and down.</source>
        <translation>Die Bewegung ist krumm: Eine Krümmung dieser Größe kann sie um bis zu %1 gedreht haben. Bewegen Sie gerade auf und ab.</translation>
    </message>
    <message>
        <source>The angle is not known well yet: record more positions over more height.</source>
        <translation>Der Winkel ist noch nicht gut bekannt: Zeichnen Sie mehr Positionen über mehr Höhe auf.</translation>
    </message>
    <message>
        <source>%1 RMS</source>
        <translation>%1 im quadr. Mittel</translation>
    </message>
    <message>
        <source>%1, as given</source>
        <translation>%1, wie angegeben</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>Beenden Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>There is no angle to save yet.</source>
        <translation>Es gibt noch keinen Winkel zu speichern.</translation>
    </message>
    <message>
        <source>Saved: %1. The Target panel can tell positions in the levelled rig&apos;s and the vehicle&apos;s frame now.</source>
        <translation>Gespeichert: %1. Das Feld „Ziel“ kann Positionen jetzt im Koordinatensystem der ausgerichteten Anlage und des Fahrzeugs angeben.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>The recording that is under way would be lost.</source>
        <translation>Die laufende Aufzeichnung ginge verloren.</translation>
    </message>
    <message>
        <source>The angle that was found has not been saved.</source>
        <translation>Der gefundene Winkel ist nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::MainWindow</name>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet…</translation>
    </message>
    <message>
        <source>simulated rig</source>
        <translation>simulierte Anlage</translation>
    </message>
    <message>
        <source>Kambara Vision – %1</source>
        <translation>Kambara Vision – %1</translation>
    </message>
    <message>
        <source>Opened: %1</source>
        <translation>Geöffnet: %1</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Pan-tilt</source>
        <translation>Schwenkkamera</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Pan-tilt picture</source>
        <translation>Bild der Schwenkkamera</translation>
    </message>
    <message>
        <source>Pan-tilt head</source>
        <translation>Schwenkkopf</translation>
    </message>
    <message>
        <source>Correlation map</source>
        <translation>Korrelationskarte</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Verläufe</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>Au&amp;fnahme</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>&amp;Ziel</translation>
    </message>
    <message>
        <source>&amp;Head</source>
        <translation>&amp;Kopf</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>H&amp;elp</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>&amp;Kalibrierung</translation>
    </message>
    <message>
        <source>Click: what is there comes to the middle</source>
        <translation>Klick: was dort ist, kommt in die Mitte</translation>
    </message>
    <message>
        <source>Tool&amp;s</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
</context>
<context>
    <name>kambara::ui::MovementView</name>
    <message>
        <source>Recorded positions</source>
        <translation>Aufgezeichnete Positionen</translation>
    </message>
    <message>
        <source>From the front: x, y</source>
        <translation>Von vorn: x, y</translation>
    </message>
    <message>
        <source>From the side: z, y</source>
        <translation>Von der Seite: z, y</translation>
    </message>
</context>
<context>
    <name>kambara::ui::OpenRecordingDialog</name>
    <message>
        <source>Open recording</source>
        <translation>Aufnahme öffnen</translation>
    </message>
    <message>
        <source>A video file, or pictures by a pattern such as left/*.png or left_%06d.png.</source>
        <translation>Eine Videodatei oder Bilder nach einem Muster wie left/*.png oder left_%06d.png.</translation>
    </message>
    <message>
        <source>Videos and pictures (*.mkv *.mp4 *.avi *.mov *.png *.jpg *.jpeg *.tif *.tiff *.bmp *.pgm *.ppm);;All files (*)</source>
        <translation>Videos und Bilder (*.mkv *.mp4 *.avi *.mov *.png *.jpg *.jpeg *.tif *.tiff *.bmp *.pgm *.ppm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>left camera&apos;s pictures</source>
        <translation>Bilder der linken Kamera</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>right camera&apos;s; empty: one camera, directions only</source>
        <translation>der rechten Kamera; leer: eine Kamera, nur Richtungen</translation>
    </message>
    <message>
        <source>Ri&amp;g file</source>
        <translation>&amp;Kalibrierdatei</translation>
    </message>
    <message>
        <source>the calibration of both</source>
        <translation>die Kalibrierung beider Kameras</translation>
    </message>
    <message>
        <source>Rig files (*.yaml *.yml);;All files (*)</source>
        <translation>Kalibrierdateien (*.yaml *.yml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>How fast single pictures follow each other; videos know it themselves.</source>
        <translation>Wie schnell Einzelbilder einander folgen; Videos wissen es selbst.</translation>
    </message>
    <message>
        <source>&amp;Single pictures at</source>
        <translation>&amp;Einzelbilder mit</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Name the left camera&apos;s pictures.</source>
        <translation>Nennen Sie die Bilder der linken Kamera.</translation>
    </message>
    <message>
        <source>Name the rig file that belongs to the pictures.</source>
        <translation>Nennen Sie die Kalibrierdatei, die zu den Bildern gehört.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::PanTiltPad</name>
    <message>
        <source>Pan-tilt pad</source>
        <translation>Steuerfeld des Schwenkkopfs</translation>
    </message>
    <message>
        <source>no head</source>
        <translation>kein Kopf</translation>
    </message>
    <message>
        <source>Press or drag to look there. The dot is where the head looks, the ring where it was told to.</source>
        <translation>Drücken oder Ziehen richtet den Blick dorthin. Der Punkt zeigt, wohin der Kopf blickt, der Ring, wohin er soll.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::PanTiltPanel</name>
    <message>
        <source>There is no pan-tilt head.</source>
        <translation>Es gibt keinen Schwenkkopf.</translation>
    </message>
    <message>
        <source>pan %1   tilt %2   %3</source>
        <translation>Schwenk %1   Neigung %2   %3</translation>
    </message>
    <message>
        <source>steered to the target</source>
        <translation>dem Ziel nachgeführt</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>The target is beyond the head&apos;s reach.</source>
        <translation>Das Ziel liegt außerhalb der Reichweite des Kopfs.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast arrow keys, stick and gamepad turn the head at most. Zoomed in they turn it more slowly by themselves.</source>
        <translation>Wie schnell Pfeiltasten, Steuerknüppel und Gamepad den Kopf höchstens drehen. Herangezoomt drehen sie ihn von selbst langsamer.</translation>
    </message>
    <message>
        <source>This head can&apos;t be turned at a speed: use the map.</source>
        <translation>Dieser Kopf kennt kein Drehen mit einer Geschwindigkeit: Benutzen Sie die Karte.</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Followed by the pan-tilt picture alone.</source>
        <translation>Nur im Bild der Schwenkkamera verfolgt.</translation>
    </message>
    <message>
        <source>Followed in the pan-tilt picture, too.</source>
        <translation>Auch im Bild der Schwenkkamera verfolgt.</translation>
    </message>
    <message>
        <source>Not seen for sure in the pan-tilt picture.</source>
        <translation>Im Bild der Schwenkkamera nicht sicher zu sehen.</translation>
    </message>
    <message>
        <source>as it last said</source>
        <translation>zuletzt gemeldet</translation>
    </message>
    <message>
        <source>waits for a target</source>
        <translation>wartet auf ein Ziel</translation>
    </message>
</context>
<context>
    <name>kambara::ui::PlaceTable</name>
    <message>
        <source>x mm</source>
        <translation>x mm</translation>
    </message>
    <message>
        <source>y mm</source>
        <translation>y mm</translation>
    </message>
    <message>
        <source>z mm</source>
        <translation>z mm</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>measured x mm</source>
        <translation>gemessen x mm</translation>
    </message>
    <message>
        <source>off mm</source>
        <translation>daneben mm</translation>
    </message>
    <message>
        <source>range error %</source>
        <translation>Entf.-Fehler %</translation>
    </message>
    <message>
        <source>Known places</source>
        <translation>Bekannte Orte</translation>
    </message>
    <message>
        <source>This is no number. Write a length in mm.</source>
        <translation>Das ist keine Zahl. Schreiben Sie eine Länge in mm.</translation>
    </message>
    <message>
        <source>spread mm</source>
        <translation>Streuung mm</translation>
    </message>
    <message>
        <source>How far the readings lie about their mean, RMS.</source>
        <translation>Wie weit die Messungen um ihr Mittel liegen, RMS.</translation>
    </message>
    <message>
        <source>So far apart that the target has moved, or another one was matched. Measure again.</source>
        <translation>So weit auseinander, dass sich das Ziel bewegt hat oder ein anderes gefunden wurde. Messen Sie noch einmal.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::PlaybackBar</name>
    <message>
        <source>Frame of the recording</source>
        <translation>Bild der Aufnahme</translation>
    </message>
    <message>
        <source>frame %1 of %2,  %3</source>
        <translation>Bild %1 von %2,  %3</translation>
    </message>
    <message>
        <source>frame %1,  %2</source>
        <translation>Bild %1,  %2</translation>
    </message>
</context>
<context>
    <name>kambara::ui::PlotsPanel</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Pause plots</source>
        <translation>Verläufe anhalten</translation>
    </message>
    <message>
        <source>Holds the drawing; nothing that comes meanwhile is lost.</source>
        <translation>Hält die Zeichnung an; was währenddessen kommt, geht nicht verloren.</translation>
    </message>
    <message>
        <source>Point at a plot to read values off.</source>
        <translation>Zeigen Sie auf einen Verlauf, um Werte abzulesen.</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>bei %1 s</translation>
    </message>
</context>
<context>
    <name>kambara::ui::RangeMap</name>
    <message>
        <source>Range errors</source>
        <translation>Entfernungsfehler</translation>
    </message>
    <message>
        <source>Ranges need a left and a right camera that see the same place.</source>
        <translation>Entfernungen brauchen eine linke und eine rechte Kamera, die denselben Ort sehen.</translation>
    </message>
    <message>
        <source>One deviation of the range, from what the calibration leaves open</source>
        <translation>Eine Standardabweichung der Entfernung aus dem, was die Kalibrierung offen lässt</translation>
    </message>
</context>
<context>
    <name>kambara::ui::RangePlots</name>
    <message>
        <source>range error, %</source>
        <translation>Entfernungsfehler, %</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>side x, mm</source>
        <translation>seitlich x, mm</translation>
    </message>
    <message>
        <source>depth z, mm</source>
        <translation>Tiefe z, mm</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>height y, mm (down)</source>
        <translation>Höhe y, mm (nach unten)</translation>
    </message>
</context>
<context>
    <name>kambara::ui::RangeResult</name>
    <message>
        <source>baseline</source>
        <translation>Basislänge</translation>
    </message>
    <message>
        <source>range, mean</source>
        <translation>Entf., Mittel</translation>
    </message>
    <message>
        <source>range, worst</source>
        <translation>Entf., größter</translation>
    </message>
    <message>
        <source>depth, mean</source>
        <translation>Tiefe, Mittel</translation>
    </message>
    <message>
        <source>depth, worst</source>
        <translation>Tiefe, größter</translation>
    </message>
    <message>
        <source>position, mean</source>
        <translation>Position, Mittel</translation>
    </message>
    <message>
        <source>position, worst</source>
        <translation>Position, größter</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>range error %1 in the mean, %2 at worst</source>
        <translation>Entfernungsfehler %1 im Mittel, höchstens %2</translation>
    </message>
    <message>
        <source>Good without any correction: %1</source>
        <translation>Gut ohne jede Korrektur: %1</translation>
    </message>
    <message>
        <source>Good after the correction of the baseline: %1</source>
        <translation>Gut nach der Korrektur der Basislänge: %1</translation>
    </message>
    <message>
        <source>Not good, even after the correction: %1</source>
        <translation>Nicht gut, auch nach der Korrektur: %1</translation>
    </message>
    <message>
        <source>Places: %1. Good is what 1999 reached with a corrected baseline: %2 in the mean, %3 at worst.</source>
        <translation>Orte: %1. Gut ist, was 1999 mit korrigierter Basislänge erreicht wurde: %2 im Mittel, höchstens %3.</translation>
    </message>
    <message>
        <source>No verdict: the target moved while it was measured, at %1 of the places. Their spread is red in the table: let it stand still and measure there again.</source>
        <translation>Kein Urteil: Das Ziel hat sich beim Messen bewegt, Zahl der Orte: %1. Ihre Streuung ist in der Tabelle rot: Lassen Sie es still stehen und messen Sie dort noch einmal.</translation>
    </message>
    <message>
        <source>Not good without a correction: %1. A baseline that is fitted to fewer than %2 places proves nothing: measure more, or give the baseline by tape.</source>
        <translation>Ohne Korrektur nicht gut: %1. Eine Basislänge, die an weniger als %2 Orte angepasst ist, beweist nichts: Messen Sie mehr, oder geben Sie die Basislänge nach Bandmaß an.</translation>
    </message>
    <message>
        <source>The corrected baseline was measured by other means.</source>
        <translation>Die korrigierte Basislänge wurde auf andere Weise gemessen.</translation>
    </message>
    <message>
        <source>The corrected baseline rests on one place alone.</source>
        <translation>Die korrigierte Basislänge beruht auf einem einzigen Ort.</translation>
    </message>
    <message>
        <source>The corrected baseline is the one that suits these places best, ±&#xa0;%1: what is left after it says nothing of scale.</source>
        <translation>Die korrigierte Basislänge ist die, die am besten zu diesen Orten passt, ±&#xa0;%1: Was danach übrig ist, sagt nichts über den Maßstab.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::RangeWindow</name>
    <message>
        <source>Range experiment</source>
        <translation>Entfernungsversuch</translation>
    </message>
    <message>
        <source>Known places</source>
        <translation>Bekannte Orte</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Clear without saving</source>
        <translation>Ohne Speichern löschen</translation>
    </message>
    <message>
        <source>Another source was opened: measuring ended.</source>
        <translation>Eine andere Quelle wurde geöffnet: Die Messung ist beendet.</translation>
    </message>
    <message>
        <source>Places read from %1: %2.</source>
        <translation>Aus %1 gelesene Orte: %2.</translation>
    </message>
    <message>
        <source>The places so far were measured by another rig. Clear the table first.</source>
        <translation>Die bisherigen Orte wurden mit einer anderen Anlage gemessen. Löschen Sie zuerst die Tabelle.</translation>
    </message>
    <message>
        <source>Begin without saving</source>
        <translation>Ohne Speichern beginnen</translation>
    </message>
    <message>
        <source>The simulated rig is being opened at its first station…</source>
        <translation>Die simulierte Anlage wird an ihrem ersten Ort geöffnet …</translation>
    </message>
    <message>
        <source>The target goes to %1 places by itself, a second each.</source>
        <translation>Das Ziel geht von selbst an %1 Orte, eine Sekunde für jeden.</translation>
    </message>
    <message>
        <source>Place %1 is measured. Bring the target to place %2, then measure.</source>
        <translation>Ort %1 ist gemessen. Bringen Sie das Ziel an Ort %2, dann messen Sie.</translation>
    </message>
    <message>
        <source>All places are measured. Judge them.</source>
        <translation>Alle Orte sind gemessen. Werten Sie sie aus.</translation>
    </message>
    <message>
        <source>Place %1: waiting for the tracked target…</source>
        <translation>Ort %1: Es wird auf das verfolgte Ziel gewartet …</translation>
    </message>
    <message>
        <source>Place %1, reading %2: </source>
        <translation>Ort %1, Messung %2: </translation>
    </message>
    <message>
        <source>estimate less truth x %1, y %2, z %3; range %4</source>
        <translation>Schätzung minus Wahrheit x %1, y %2, z %3; Entfernung %4</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3</source>
        <translation>x %1, y %2, z %3</translation>
    </message>
    <message>
        <source>&amp;Stop measuring</source>
        <translation>Messung &amp;beenden</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Positions need a rig of two cameras.</source>
        <translation>Positionen brauchen eine Anlage mit zwei Kameras.</translation>
    </message>
    <message>
        <source>Averages the tracked target&apos;s next positions.</source>
        <translation>Mittelt die nächsten Positionen des verfolgten Ziels.</translation>
    </message>
    <message>
        <source>Choose a place whose coordinates are known.</source>
        <translation>Wählen Sie einen Ort, dessen Koordinaten bekannt sind.</translation>
    </message>
    <message>
        <source>St&amp;op the simulation</source>
        <translation>Simulation &amp;beenden</translation>
    </message>
    <message>
        <source>S&amp;imulated experiment</source>
        <translation>S&amp;imulierter Versuch</translation>
    </message>
    <message>
        <source>Measure a place first.</source>
        <translation>Messen Sie zuerst einen Ort.</translation>
    </message>
    <message>
        <source>Place %1 has no coordinates. Write them, or remove it.</source>
        <translation>Ort %1 hat keine Koordinaten. Schreiben Sie sie, oder entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>Places that took no part, since they were not measured: %1.</source>
        <translation>Orte, die nicht teilnahmen, weil sie nicht gemessen sind: %1.</translation>
    </message>
    <message>
        <source>Simulated places that the target was not followed to: %1.</source>
        <translation>Simulierte Orte, an die das Ziel nicht verfolgt wurde: %1.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>The measured places have not been saved.</source>
        <translation>Die gemessenen Orte sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Measure the places and judge them first.</source>
        <translation>Messen Sie zuerst die Orte und werten Sie sie aus.</translation>
    </message>
    <message>
        <source>left camera</source>
        <translation>linke Kamera</translation>
    </message>
    <message>
        <source>rig</source>
        <translation>Anlage</translation>
    </message>
    <message>
        <source>their own</source>
        <translation>ihr eigenes</translation>
    </message>
    <message>
        <source>The frame in which the places are known. Their own: it is laid upon the measured places by least squares, and what is left is judged.</source>
        <translation>Das Koordinatensystem, in dem die Orte bekannt sind. Ihr eigenes: Es wird nach kleinsten Quadraten auf die gemessenen Orte gelegt, und was bleibt, wird beurteilt.</translation>
    </message>
    <message>
        <source>&amp;Frame of the places</source>
        <translation>Koordinatens&amp;ystem der Orte</translation>
    </message>
    <message>
        <source>Readings a &amp;place</source>
        <translation>Messungen &amp;je Ort</translation>
    </message>
    <message>
        <source>&amp;Baseline by tape:</source>
        <translation>&amp;Basislänge nach Maßband:</translation>
    </message>
    <message>
        <source>The correction is to this baseline. Without it, to the one that suits the places best.</source>
        <translation>Auf diese Basislänge wird korrigiert. Ohne sie auf die, die am besten zu den Orten passt.</translation>
    </message>
    <message>
        <source>There are no known places yet.

Add them one by one, or load a table whose columns are x_mm, y_mm, z_mm: x to the right, y down, z ahead.

Then bring the tracked target to each place and measure. The simulated experiment does all of it by itself, in 75 seconds.</source>
        <translation>Es gibt noch keine bekannten Orte.

Fügen Sie sie einzeln hinzu, oder laden Sie eine Tabelle mit den Spalten x_mm, y_mm, z_mm: x nach rechts, y nach unten, z voraus.

Dann bringen Sie das verfolgte Ziel an jeden Ort und messen. Der simulierte Versuch tut all das von selbst, in 75 Sekunden.</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>&amp;Laden …</translation>
    </message>
    <message>
        <source>&amp;Add a place</source>
        <translation>Ort &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Judge</source>
        <translation>Aus&amp;werten</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tabelle (CSV)</translation>
    </message>
    <message>
        <source>Save &amp;table</source>
        <translation>&amp;Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Report (HTML)</source>
        <translation>Bericht (HTML)</translation>
    </message>
    <message>
        <source>Save &amp;report</source>
        <translation>&amp;Bericht speichern</translation>
    </message>
    <message>
        <source>Reports (*.html)</source>
        <translation>Berichte (*.html)</translation>
    </message>
    <message>
        <source>“%1” is no number. Write a length in mm.</source>
        <translation>„%1“ ist keine Zahl. Schreiben Sie eine Länge in mm.</translation>
    </message>
    <message>
        <source>The target moved while place %1 was measured: its readings lie %2 about their mean. Let it stand still and measure there again.</source>
        <translation>Das Ziel hat sich beim Messen von Ort %1 bewegt: Die Messungen liegen %2 um ihr Mittel. Lassen Sie es still stehen und messen Sie dort noch einmal.</translation>
    </message>
    <message>
        <source>; spread %1</source>
        <translation>; Streuung %1</translation>
    </message>
    <message>
        <source>Places that were typed and not measured yet would be lost: %1.</source>
        <translation>Eingetippte, noch nicht gemessene Orte gingen verloren: %1.</translation>
    </message>
    <message>
        <source>Positions that are averaged where you measure. The simulated experiment stays at each place for a second and takes what comes.</source>
        <translation>So viele Positionen werden gemittelt, wo Sie messen. Der simulierte Versuch bleibt an jedem Ort eine Sekunde und nimmt, was kommt.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::ResidualPlot</name>
    <message>
        <source>%1: residuals %2, drawn %3 times as long</source>
        <translation>%1: Restfehler %2, %3-mal so lang gezeichnet</translation>
    </message>
</context>
<context>
    <name>kambara::ui::ResultPage</name>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Rig file</source>
        <translation>Rig-Datei</translation>
    </message>
    <message>
        <source>&amp;Save rig</source>
        <translation>Rig &amp;speichern</translation>
    </message>
    <message>
        <source>Report (HTML)</source>
        <translation>Bericht (HTML)</translation>
    </message>
    <message>
        <source>Save &amp;report</source>
        <translation>&amp;Bericht speichern</translation>
    </message>
    <message>
        <source>&amp;Back to the shots</source>
        <translation>&amp;Zurück zu den Aufnahmen</translation>
    </message>
    <message>
        <source>Verdict: good</source>
        <translation>Urteil: gut</translation>
    </message>
    <message>
        <source>Verdict: usable</source>
        <translation>Urteil: brauchbar</translation>
    </message>
    <message>
        <source>Verdict: refused</source>
        <translation>Urteil: abgelehnt</translation>
    </message>
    <message>
        <source>Nothing speaks against it. Save the rig, then use it for tracking.</source>
        <translation>Nichts spricht dagegen. Speichern Sie das Rig und verwenden Sie es zum Verfolgen.</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Range errors</source>
        <translation>Entfernungsfehler</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>A refused calibration gives no rig: take more shots.</source>
        <translation>Eine abgelehnte Kalibrierung ergibt kein Rig: Machen Sie weitere Aufnahmen.</translation>
    </message>
    <message>
        <source>Writes the rig with the pictures&apos; hashes, settings, date</source>
        <translation>Schreibt das Rig mit Prüfsummen der Bilder, Einstellungen und Datum</translation>
    </message>
    <message>
        <source>Shots used</source>
        <translation>Verwendete Aufnahmen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Corners used</source>
        <translation>Verwendete Ecken</translation>
    </message>
    <message>
        <source>Left to %1</source>
        <translation>Links bis %1</translation>
    </message>
    <message>
        <source>Lengths in shots that took no part</source>
        <translation>Längen in unbeteiligten Aufnahmen</translation>
    </message>
    <message>
        <source>%1 off in the mean</source>
        <translation>im Mittel %1 falsch</translation>
    </message>
    <message>
        <source>Shot %1 left out</source>
        <translation>Aufnahme %1 ausgelassen</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>kambara::ui::SaveRow</name>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>The file has no name. Write one, or choose a place.</source>
        <translation>Die Datei hat keinen Namen. Schreiben Sie einen, oder wählen Sie einen Ort.</translation>
    </message>
    <message>
        <source>%1 is a folder. Write a file&apos;s name behind it.</source>
        <translation>%1 ist ein Ordner. Schreiben Sie einen Dateinamen dahinter.</translation>
    </message>
    <message>
        <source>The folder %1 can&apos;t be made. Choose a place that can be written to.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden. Wählen Sie einen Ort, an dem geschrieben werden darf.</translation>
    </message>
    <message>
        <source>%1 is there already. Write over it?</source>
        <translation>%1 gibt es schon. Überschreiben?</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Überschreiben</translation>
    </message>
</context>
<context>
    <name>kambara::ui::SceneView</name>
    <message>
        <source>left green, right cyan, pan-tilt amber
95 % ellipsoid drawn %1 times as large</source>
        <translation>links grün, rechts cyan, Schwenkkamera bernsteinfarben
95-%-Ellipsoid %1-fach vergrößert gezeichnet</translation>
    </message>
    <message>
        <source>There is no 3-D view: OpenGL 3.2 is not available here.
Everything else works. To have it, install a graphics driver or run the program where the screen is.</source>
        <translation>Es gibt keine 3-D-Ansicht: OpenGL 3.2 ist hier nicht verfügbar.
Alles andere läuft. Für die Ansicht einen Grafiktreiber installieren oder das Programm dort starten, wo der Bildschirm ist.</translation>
    </message>
    <message>
        <source>Behind</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Look along with the cameras</source>
        <translation>In Blickrichtung der Kameras</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Look down on the rig</source>
        <translation>Von oben auf die Anlage</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the target in the middle</source>
        <translation>Hält das Ziel in der Mitte</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Forgets where the target was</source>
        <translation>Vergisst, wo das Ziel war</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Writes the 3-D view as a PNG file</source>
        <translation>Schreibt die 3-D-Ansicht als PNG-Datei</translation>
    </message>
    <message>
        <source>Save 3-D picture</source>
        <translation>3-D-Bild speichern</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>%1 can&apos;t be written. Choose a folder that you may write to.</source>
        <translation>%1 kann nicht geschrieben werden. Wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::SetupPage</name>
    <message>
        <source>&lt;h2&gt;Calibrate the cameras&lt;/h2&gt;You show the target to all cameras, about twelve times. The next page draws in blue where to hold it; the pictures are taken by themselves while it is held still.</source>
        <translation>&lt;h2&gt;Die Kameras kalibrieren&lt;/h2&gt;Sie zeigen den Zielkörper allen Kameras, etwa zwölfmal. Die nächste Seite zeichnet blau, wohin er gehört; die Bilder entstehen von selbst, während er stillgehalten wird.</translation>
    </message>
    <message>
        <source>A target&apos;s short form, or its file (.yaml)</source>
        <translation>Die Kurzform eines Zielkörpers oder seine Datei (.yaml)</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>&amp;Zielkörper</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Brown (most lenses)</source>
        <translation>Brown (die meisten Linsen)</translation>
    </message>
    <message>
        <source>Tsai (as in 1999)</source>
        <translation>Tsai (wie 1999)</translation>
    </message>
    <message>
        <source>&amp;Lens model</source>
        <translation>&amp;Linsenmodell</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>What the cameras look through while they are calibrated</source>
        <translation>Wodurch die Kameras blicken, während sie kalibriert werden</translation>
    </message>
    <message>
        <source>&amp;Medium</source>
        <translation>&amp;Medium</translation>
    </message>
    <message>
        <source>Measured by tape:</source>
        <translation>Mit dem Maßband gemessen:</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Basislinie</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Resume a session…</source>
        <translation>Sitzung &amp;fortsetzen …</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>Tsai&apos;s model takes the sensor of the rig in use</source>
        <translation>Tsais Modell nimmt den Sensor des verwendeten Rigs</translation>
    </message>
    <message>
        <source>Tsai&apos;s model needs the sensor&apos;s numbers, which the rig in use does not have.</source>
        <translation>Tsais Modell braucht die Zahlen des Sensors, die das verwendete Rig nicht hat.</translation>
    </message>
    <message>
        <source>%1 (%2 × %3 px)</source>
        <translation>%1 (%2 × %3 px)</translation>
    </message>
    <message>
        <source>It gives no pictures.</source>
        <translation>Sie liefert keine Bilder.</translation>
    </message>
    <message>
        <source>The left camera always takes part.</source>
        <translation>Die linke Kamera ist immer beteiligt.</translation>
    </message>
    <message>
        <source>With its head at home</source>
        <translation>Mit dem Kopf in Ruhestellung</translation>
    </message>
    <message>
        <source>A list of points can&apos;t be found in pictures: choose another target.</source>
        <translation>Eine Liste von Punkten ist in Bildern nicht zu finden: Wählen Sie einen anderen Zielkörper.</translation>
    </message>
    <message>
        <source>Name a folder for the session.</source>
        <translation>Nennen Sie einen Ordner für die Sitzung.</translation>
    </message>
    <message>
        <source>Begins a session in a new folder</source>
        <translation>Beginnt eine Sitzung in einem neuen Ordner</translation>
    </message>
    <message>
        <source>A folder for the session</source>
        <translation>Ein Ordner für die Sitzung</translation>
    </message>
    <message>
        <source>The session to resume</source>
        <translation>Die fortzusetzende Sitzung</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Saves the target as a PDF file at its true size, a page a plane</source>
        <translation>Speichert den Zielkörper als PDF-Datei in wahrer Größe, eine Seite je Ebene</translation>
    </message>
    <message>
        <source>Saved as %1: paper %2, pages: %3. Print it at 100&#x202f;% and measure the ruler on it.</source>
        <translation>Gespeichert als %1: Papier %2, Seiten: %3. Drucken Sie es mit 100&#x202f;% und messen Sie den Maßstab darauf nach.</translation>
    </message>
    <message>
        <source>Save the target to print</source>
        <translation>Zielkörper zum Drucken speichern</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
    <message>
        <source>No picture has come yet: open a source, or play the recording.</source>
        <translation>Noch ist kein Bild gekommen: Öffnen Sie eine Quelle, oder spielen Sie die Aufzeichnung ab.</translation>
    </message>
</context>
<context>
    <name>kambara::ui::StatusFields</name>
    <message>
        <source>Where the pictures come from</source>
        <translation>Woher die Bilder kommen</translation>
    </message>
    <message>
        <source>The medium the calibration holds for</source>
        <translation>Das Medium, für das die Kalibrierung gilt</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Pairs of pictures handled in a second</source>
        <translation>In einer Sekunde verarbeitete Bildpaare</translation>
    </message>
    <message>
        <source>From a pair&apos;s arrival to its result</source>
        <translation>Vom Eintreffen eines Bildpaars bis zum Ergebnis</translation>
    </message>
    <message>
        <source>latency %1</source>
        <translation>Verzögerung %1</translation>
    </message>
    <message>
        <source>Pairs that came while the pipeline was busy, or without a partner</source>
        <translation>Bildpaare, die bei belegter Verarbeitung oder ohne Partner kamen</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>The gamepad: left stick turns the head, triggers zoom, the right one of the four buttons halts</source>
        <translation>Das Gamepad: linker Stick dreht den Kopf, die Schultertasten zoomen, die rechte der vier Tasten hält an</translation>
    </message>
    <message>
        <source>no gamepad</source>
        <translation>kein Gamepad</translation>
    </message>
    <message>
        <source>%1: let the sticks go first</source>
        <translation>%1: erst die Sticks loslassen</translation>
    </message>
    <message>
        <source>%1: ready</source>
        <translation>%1: bereit</translation>
    </message>
    <message>
        <source>%1: does not answer, let the sticks go</source>
        <translation>%1: antwortet nicht, Sticks loslassen</translation>
    </message>
    <message>
        <source>%1 pairs lost</source>
        <translation>%1 Paare verloren</translation>
    </message>
</context>
<context>
    <name>kambara::ui::TargetLine</name>
    <message>
        <source>No target is tracked: drag a rectangle over it in the main window&apos;s left picture.</source>
        <translation>Kein Ziel wird verfolgt: Ziehen Sie im linken Bild des Hauptfensters ein Rechteck darüber.</translation>
    </message>
    <message>
        <source>The target is chosen but not followed: start tracking (F5) in the main window.</source>
        <translation>Das Ziel ist gewählt, wird aber nicht verfolgt: Starten Sie die Verfolgung (F5) im Hauptfenster.</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>%1 entfernt</translation>
    </message>
</context>
<context>
    <name>kambara::ui::TrackPanel</name>
    <message>
        <source>Start tracking (F5) follows it; a new rectangle replaces it.</source>
        <translation>„Verfolgung starten“ (F5) folgt ihr; ein neues Rechteck ersetzt sie.</translation>
    </message>
    <message>
        <source>x (right)</source>
        <translation>x (rechts)</translation>
    </message>
    <message>
        <source>y (down)</source>
        <translation>y (unten)</translation>
    </message>
    <message>
        <source>z (ahead)</source>
        <translation>z (voraus)</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>Distance from the left camera.</source>
        <translation>Abstand von der linken Kamera.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>How like the template the target is, in the worse of both pictures.</source>
        <translation>Wie ähnlich das Ziel der Vorlage ist, im schlechteren der beiden Bilder.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>How far the two matches are from a common point.</source>
        <translation>Wie weit die beiden Treffer von einem gemeinsamen Punkt entfernt sind.</translation>
    </message>
    <message>
        <source>By calibration</source>
        <translation>Durch Kalibrierung</translation>
    </message>
    <message>
        <source>One standard deviation of x, y, z that the calibration leaves: it does not average out. Known where the rig file tells its covariance.</source>
        <translation>Eine Standardabweichung von x, y, z, die die Kalibrierung übrig lässt: Sie mittelt sich nicht heraus. Bekannt, wo die Kalibrierdatei ihre Kovarianz nennt.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Template updates</source>
        <translation>Vorlage erneuert</translation>
    </message>
    <message>
        <source>How often a fresh template was cut since the target was chosen.</source>
        <translation>Wie oft seit der Wahl des Ziels eine neue Vorlage ausgeschnitten wurde.</translation>
    </message>
    <message>
        <source>Drag a rectangle over the target in the left picture.</source>
        <translation>Ziehen Sie im linken Bild ein Rechteck über das Ziel.</translation>
    </message>
    <message>
        <source>Steered target</source>
        <translation>Ziel des Kopfs</translation>
    </message>
    <message>
        <source>Ctrl + drag in the left picture chooses one more target; Ctrl + click on one steers to it.</source>
        <translation>Ziehen mit Strg im linken Bild wählt ein weiteres Ziel; Klicken mit Strg auf eines lässt den Kopf ihm folgen.</translation>
    </message>
    <message>
        <source>number %1, one of %2</source>
        <translation>Nummer %1, eines von %2</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>In the frame chosen above; ± one standard deviation from image noise.</source>
        <translation>Im oben gewählten Koordinatensystem; ± eine Standardabweichung aus dem Bildrauschen.</translation>
    </message>
    <message>
        <source>left camera</source>
        <translation>linke Kamera</translation>
    </message>
    <message>
        <source>rig</source>
        <translation>Anlage</translation>
    </message>
    <message>
        <source>rig, levelled</source>
        <translation>Anlage, ausgerichtet</translation>
    </message>
    <message>
        <source>vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>The frame in which the position is told. The last two need a rig whose mount is known: Tools &gt; Levelling finds it.</source>
        <translation>Das Koordinatensystem, in dem die Position angegeben wird. Die letzten zwei brauchen eine Anlage, deren Einbau bekannt ist: Werkzeuge &gt; Ausrichten findet ihn.</translation>
    </message>
    <message>
        <source>Fra&amp;me</source>
        <translation>&amp;Bezug</translation>
    </message>
    <message>
        <source>x (forward)</source>
        <translation>x (voraus)</translation>
    </message>
    <message>
        <source>y (right)</source>
        <translation>y (rechts)</translation>
    </message>
    <message>
        <source>z (down)</source>
        <translation>z (unten)</translation>
    </message>
</context>
<context>
    <name>kambara::ui::VideoView</name>
    <message>
        <source>   red %1  green %2  blue %3</source>
        <translation>   Rot %1  Grün %2  Blau %3</translation>
    </message>
    <message>
        <source>   grey %1</source>
        <translation>   Grau %1</translation>
    </message>
    <message>
        <source>%1: no picture</source>
        <translation>%1: kein Bild</translation>
    </message>
    <message>
        <source>%1   frame %2</source>
        <translation>%1   Bild %2</translation>
    </message>
    <message>
        <source>FROZEN</source>
        <translation>ANGEHALTEN</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>%1 alt</translation>
    </message>
</context>
<context>
    <name>kambara::ui::WindowActions</name>
    <message>
        <source>&amp;Open recording…</source>
        <translation>Aufnahme ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Opens pictures or videos of both cameras</source>
        <translation>Öffnet Bilder oder Videos beider Kameras</translation>
    </message>
    <message>
        <source>&amp;Simulated rig</source>
        <translation>&amp;Simulierte Anlage</translation>
    </message>
    <message>
        <source>Runs on the simulated rig, live</source>
        <translation>Läuft an der simulierten Anlage</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Closes the program</source>
        <translation>Schließt das Programm</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Lets the recording run, or holds it</source>
        <translation>Lässt die Aufnahme laufen oder hält sie an</translation>
    </message>
    <message>
        <source>S&amp;tep</source>
        <translation>S&amp;chritt</translation>
    </message>
    <message>
        <source>Takes one pair of pictures</source>
        <translation>Nimmt ein Bildpaar</translation>
    </message>
    <message>
        <source>&amp;Freeze picture</source>
        <translation>Bild an&amp;halten</translation>
    </message>
    <message>
        <source>Holds the left picture still, to choose a target in it; the pipeline goes on</source>
        <translation>Hält das linke Bild an, um darin ein Ziel zu wählen; die Verarbeitung läuft weiter</translation>
    </message>
    <message>
        <source>&amp;Select target</source>
        <translation>Ziel &amp;wählen</translation>
    </message>
    <message>
        <source>St&amp;art tracking</source>
        <translation>Verfolgung &amp;starten</translation>
    </message>
    <message>
        <source>Follows the template again</source>
        <translation>Folgt der Vorlage wieder</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Stops tracking and halts the head; the template is kept</source>
        <translation>Beendet die Verfolgung und hält den Kopf an; die Vorlage bleibt</translation>
    </message>
    <message>
        <source>&amp;Update template</source>
        <translation>Vorlage &amp;erneuern</translation>
    </message>
    <message>
        <source>Takes what is seen now as the new template</source>
        <translation>Nimmt das jetzt Gesehene als neue Vorlage</translation>
    </message>
    <message>
        <source>&amp;Clear template</source>
        <translation>Vorlage &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Steer</source>
        <translation>&amp;Nachführen</translation>
    </message>
    <message>
        <source>Steers the head to the target; off: it is moved by hand</source>
        <translation>Führt den Kopf dem Ziel nach; aus: er wird von Hand bewegt</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>&amp;Grundstellung</translation>
    </message>
    <message>
        <source>Turns the head straight ahead</source>
        <translation>Dreht den Kopf geradeaus</translation>
    </message>
    <message>
        <source>Hal&amp;t head</source>
        <translation>Kopf &amp;anhalten</translation>
    </message>
    <message>
        <source>Stops the head at once, from anywhere in the program</source>
        <translation>Hält den Kopf sofort an, von überall im Programm</translation>
    </message>
    <message>
        <source>&amp;Stretch map contrast</source>
        <translation>&amp;Kontrast der Karte spreizen</translation>
    </message>
    <message>
        <source>Spreads the map&apos;s colours over the values it holds</source>
        <translation>Spreizt die Farben der Karte über die vorhandenen Werte</translation>
    </message>
    <message>
        <source>&amp;Restore default layout</source>
        <translation>&amp;Standardanordnung wiederherstellen</translation>
    </message>
    <message>
        <source>Puts all parts of the window back in their places</source>
        <translation>Setzt alle Teile des Fensters an ihren Platz zurück</translation>
    </message>
    <message>
        <source>&amp;About Kambara</source>
        <translation>Ü&amp;ber Kambara</translation>
    </message>
    <message>
        <source>Versions and licences</source>
        <translation>Versionen und Lizenzen</translation>
    </message>
    <message>
        <source>Open a source first.</source>
        <translation>Öffnen Sie erst eine Quelle.</translation>
    </message>
    <message>
        <source>There is no pan-tilt head.</source>
        <translation>Es gibt keinen Schwenkkopf.</translation>
    </message>
    <message>
        <source>The recording is over: go back first.</source>
        <translation>Die Aufnahme ist zu Ende: gehen Sie erst zurück.</translation>
    </message>
    <message>
        <source>Only a recording can be held.</source>
        <translation>Nur eine Aufnahme kann angehalten werden.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Only a recording can be stepped.</source>
        <translation>Nur eine Aufnahme hat Einzelschritte.</translation>
    </message>
    <message>
        <source>Pause the recording first.</source>
        <translation>Halten Sie die Aufnahme erst an.</translation>
    </message>
    <message>
        <source>The target is followed already.</source>
        <translation>Das Ziel wird schon verfolgt.</translation>
    </message>
    <message>
        <source>Choose a target first.</source>
        <translation>Wählen Sie erst ein Ziel.</translation>
    </message>
    <message>
        <source>The target must be in sight.</source>
        <translation>Das Ziel muss zu sehen sein.</translation>
    </message>
    <message>
        <source>There is no template.</source>
        <translation>Es gibt keine Vorlage.</translation>
    </message>
    <message>
        <source>Offers a rectangle in the left picture: arrow keys move it, with Shift they change its size, Enter takes it. With the mouse: drag a rectangle. With Ctrl: one more target</source>
        <translation>Bietet im linken Bild ein Rechteck an: Pfeiltasten verschieben es, mit Umschalt ändern sie seine Größe, Eingabe übernimmt es. Mit der Maus: ein Rechteck ziehen. Mit Strg: ein weiteres Ziel</translation>
    </message>
    <message>
        <source>Forgets all targets</source>
        <translation>Vergisst alle Ziele</translation>
    </message>
    <message>
        <source>&amp;Calibrate…</source>
        <translation>&amp;Kalibrieren …</translation>
    </message>
    <message>
        <source>Calibrates the cameras, step by step</source>
        <translation>Kalibriert die Kameras, Schritt für Schritt</translation>
    </message>
    <message>
        <source>The source is over: there are no pictures to calibrate from.</source>
        <translation>Die Quelle ist zu Ende: Es gibt keine Bilder zum Kalibrieren.</translation>
    </message>
    <message>
        <source>&amp;Reset head</source>
        <translation>Kopf &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Lets the head find its home position anew, as after it was turned by force</source>
        <translation>Lässt den Kopf seine Grundstellung neu suchen, etwa nachdem er gewaltsam gedreht wurde</translation>
    </message>
    <message>
        <source>This head can&apos;t be reset.</source>
        <translation>Dieser Kopf lässt sich nicht zurücksetzen.</translation>
    </message>
    <message>
        <source>&amp;Levelling…</source>
        <translation>&amp;Ausrichten …</translation>
    </message>
    <message>
        <source>Finds the angle in which the rig is mounted</source>
        <translation>Findet den Winkel, in dem die Anlage eingebaut ist</translation>
    </message>
    <message>
        <source>&amp;Range experiment…</source>
        <translation>&amp;Entfernungsversuch …</translation>
    </message>
    <message>
        <source>Holds measured positions against known places</source>
        <translation>Hält gemessene Positionen gegen bekannte Orte</translation>
    </message>
    <message>
        <source>&amp;Head calibration…</source>
        <translation>&amp;Kalibrierung des Kopfs …</translation>
    </message>
    <message>
        <source>Finds the pan-tilt head&apos;s axes, lever arms and backlash</source>
        <translation>Findet Achsen, Hebelarme und Spiel des Schwenkkopfs</translation>
    </message>
    <message>
        <source>Follow in its &amp;picture</source>
        <translation>In seinem &amp;Bild verfolgen</translation>
    </message>
    <message>
        <source>Follows the target in the pan-tilt picture, too: that makes the aim right, and stands in where the stereo pair does not see it</source>
        <translation>Verfolgt das Ziel auch im Bild der Schwenkkamera: Das berichtigt die Richtung und springt ein, wo das Stereopaar es nicht sieht</translation>
    </message>
    <message>
        <source>There is no pan-tilt picture.</source>
        <translation>Es gibt kein Bild der Schwenkkamera.</translation>
    </message>
    <message>
        <source>Close &amp;form</source>
        <translation>&amp;Formular schließen</translation>
    </message>
    <message>
        <source>Closes the form or the calibration that is in front</source>
        <translation>Schließt das Formular oder die Kalibrierung, die vorn ist</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Shows every key and what it does</source>
        <translation>Zeigt jede Taste und was sie tut</translation>
    </message>
    <message>
        <source>&amp;Zoom calibration…</source>
        <translation>&amp;Zoom kalibrieren …</translation>
    </message>
    <message>
        <source>Measures how much the head&apos;s lens enlarges</source>
        <translation>Misst, wie stark das Objektiv des Kopfes vergrößert</translation>
    </message>
</context>
<context>
    <name>kambara::ui::ZoomWindow</name>
    <message>
        <source>Zoom calibration</source>
        <translation>Zoomkalibrierung</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>enlarges</source>
        <translation>vergrößert</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>by the head&apos;s table</source>
        <translation>laut Tabelle des Kopfes</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Places of the zoom</source>
        <translation>Stellen des Zooms</translation>
    </message>
    <message>
        <source>Nothing is measured yet.

Turn the head to a scene at rest with much detail, some metres away, and go through the zoom: the lens goes from wide to tele by itself, and from each picture to the next it is measured how much larger things have become.

What a maker&apos;s table says between the ends of a zoom is seldom known; this is what this head does.</source>
        <translation>Noch ist nichts gemessen.

Richten Sie den Kopf auf eine ruhende Szene mit vielen Einzelheiten, einige Meter entfernt, und fahren Sie den Zoom durch: Das Objektiv geht von selbst von Weitwinkel zu Tele, und von jedem Bild zum nächsten wird gemessen, um wie viel größer die Dinge geworden sind.

Was die Tabelle eines Herstellers zwischen den Enden eines Zooms sagt, ist selten bekannt; dies ist, was dieser Kopf tut.</translation>
    </message>
    <message>
        <source>&amp;Kind of head</source>
        <translation>&amp;Art des Kopfes</translation>
    </message>
    <message>
        <source>Table of &amp;heads</source>
        <translation>Tabelle der &amp;Köpfe</translation>
    </message>
    <message>
        <source>&amp;Save table</source>
        <translation>Tabelle &amp;speichern</translation>
    </message>
    <message>
        <source>Tables of heads (*.yaml)</source>
        <translation>Tabellen der Köpfe (*.yaml)</translation>
    </message>
    <message>
        <source>Another source was opened: it ended.</source>
        <translation>Eine andere Quelle wurde geöffnet: Die Messung ist beendet.</translation>
    </message>
    <message>
        <source>No source is open: open one in the main window.</source>
        <translation>Keine Quelle ist offen: Öffnen Sie eine im Hauptfenster.</translation>
    </message>
    <message>
        <source>The rig in use holds no pan-tilt camera: calibrate it first, at its widest (Calibration &gt; Calibrate).</source>
        <translation>Die benutzte Anlage hat keine Schwenkkamera: Kalibrieren Sie sie zuerst, in weitester Stellung (Kalibrierung &gt; Kalibrieren).</translation>
    </message>
    <message>
        <source>This source has no head that zooms.</source>
        <translation>Diese Quelle hat keinen Kopf, der zoomt.</translation>
    </message>
    <message>
        <source>The head has not told its zoom yet.</source>
        <translation>Der Kopf hat seinen Zoom noch nicht gemeldet.</translation>
    </message>
    <message>
        <source>The head&apos;s camera delivers no pictures.</source>
        <translation>Die Kamera des Kopfes liefert keine Bilder.</translation>
    </message>
    <message>
        <source>Measure anew</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>The lens goes from wide to tele. Keep the head and what it looks at still.</source>
        <translation>Das Objektiv fährt von Weitwinkel zu Tele. Halten Sie den Kopf und das, was er ansieht, still.</translation>
    </message>
    <message>
        <source>The lens is at zoom %1.</source>
        <translation>Das Objektiv steht bei Zoom %1.</translation>
    </message>
    <message>
        <source>Place %1 of %2.</source>
        <translation>Stelle %1 von %2.</translation>
    </message>
    <message>
        <source>The head was turned meanwhile. Keep it still, and begin again.</source>
        <translation>Der Kopf wurde währenddessen gedreht. Halten Sie ihn still und beginnen Sie von vorn.</translation>
    </message>
    <message>
        <source>No new picture came for 15 seconds. Check the head&apos;s camera.</source>
        <translation>Seit 15 Sekunden kam kein neues Bild. Prüfen Sie die Kamera des Kopfes.</translation>
    </message>
    <message>
        <source>The lens did not get to zoom %1 within 15 seconds. Check the head&apos;s line, then begin again.</source>
        <translation>Das Objektiv kam innerhalb von 15 Sekunden nicht zu Zoom %1. Prüfen Sie die Leitung des Kopfes und beginnen Sie von vorn.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Wird gemessen …</translation>
    </message>
    <message>
        <source>The lens enlarges up to %1 times. The head did not know.</source>
        <translation>Das Objektiv vergrößert bis %1-fach. Der Kopf wusste es nicht.</translation>
    </message>
    <message>
        <source>The lens enlarges up to %1 times. What the head&apos;s table says is off by %2 at most.</source>
        <translation>Das Objektiv vergrößert bis %1-fach. Was die Tabelle des Kopfes sagt, ist um höchstens %2 falsch.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Go through the zoom</source>
        <translation>Zoom &amp;durchfahren</translation>
    </message>
    <message>
        <source>Go through the zoom first: there is no curve.</source>
        <translation>Fahren Sie zuerst den Zoom durch: Es gibt keine Kurve.</translation>
    </message>
    <message>
        <source>Saved: %1. Name it in the head&apos;s address to use it: heads=%1</source>
        <translation>Gespeichert: %1. Nennen Sie sie in der Adresse des Kopfes, um sie zu benutzen: heads=%1</translation>
    </message>
    <message>
        <source>The zoom&apos;s curve that was measured has not been saved.</source>
        <translation>Die gemessene Kurve des Zooms ist nicht gespeichert.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>&amp;Widest focal length</source>
        <translation>Kürzeste &amp;Brennweite</translation>
    </message>
    <message>
        <source>sensor&apos;s &amp;width</source>
        <translation>Breite des S&amp;ensors</translation>
    </message>
    <message>
        <source>Choose the kind of head first.</source>
        <translation>Wählen Sie zuerst die Art des Kopfes.</translation>
    </message>
    <message>
        <source>Tell the lens&apos; focal length at its widest and the sensor&apos;s width first: the head&apos;s manual has them.</source>
        <translation>Nennen Sie zuerst die kürzeste Brennweite des Objektivs und die Breite des Sensors: Sie stehen im Handbuch des Kopfes.</translation>
    </message>
</context>
</TS>
