// lds-studio as a person starts it: its options, its exit codes, and the tour.

#include <QDir>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

class StudioProgramFlow : public QObject {
    Q_OBJECT

    struct Ended {
        int code;
        QString output;
        QString error;
    };

    static Ended run(const QStringList& arguments, int timeoutMs = 60'000)
    {
        QProcess process;
        process.start(qEnvironmentVariable("LDS_BIN") + u"/lds-studio"_s, arguments);
        if (!process.waitForFinished(timeoutMs)) {
            process.kill();
            process.waitForFinished();
            return {-1, {}, u"did not end"_s};
        }
        return {process.exitCode(), QString::fromLocal8Bit(process.readAllStandardOutput()),
                QString::fromLocal8Bit(process.readAllStandardError())};
    }

private Q_SLOTS:
    void helpAndVersionEndWithZero()
    {
        const Ended help = run({u"--help"_s});
        QCOMPARE(help.code, 0);
        for (const QString& option : {u"--demo"_s, u"--sensor"_s, u"--connect"_s, u"--tour"_s, u"--theme"_s})
            QVERIFY2(help.output.contains(option), qPrintable(option));
        const Ended version = run({u"--version"_s});
        QCOMPARE(version.code, 0);
        QCOMPARE(version.output, u"lds-studio %1\n"_s.arg(QLatin1StringView(LDS_VERSION)));
    }

    void wrongUsageEndsWithTwoAndASentence_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("word");
        QTest::newRow("unknown option") << QStringList{u"--frobnicate"_s} << u"frobnicate"_s;
        QTest::newRow("stray word") << QStringList{u"sensor7"_s} << u"sensor7"_s;
        QTest::newRow("no such type")
            << QStringList{u"--demo"_s, u"--sensor"_s, u"HL-G999"_s} << u"HL-G203B-S-MK"_s;
        QTest::newRow("type without demo") << QStringList{u"--sensor"_s, u"HL-G203B-S-MK"_s} << u"--demo"_s;
        QTest::newRow("no URL") << QStringList{u"--connect"_s, u"sensor7"_s} << u"scheme"_s;
        QTest::newRow("port out of range")
            << QStringList{u"--connect"_s, u"modbus-tcp://a:70000"_s} << u"port"_s;
        QTest::newRow("no such theme") << QStringList{u"--theme"_s, u"pink"_s} << u"pink"_s;
    }
    void wrongUsageEndsWithTwoAndASentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, word);
        const Ended ended = run(arguments);
        QCOMPARE(ended.code, 2);
        QVERIFY2(ended.error.startsWith(u"lds-studio: "_s) && ended.error.contains(word),
                 qPrintable(ended.error));
        QVERIFY(ended.output.isEmpty());
    }

    void theTourRendersTheMainScreensAndNamesThem()
    {
        const QTemporaryDir folder;
        const Ended ended = run({u"--tour"_s, folder.filePath(u"new/pictures"_s)}, 150'000);
        QVERIFY2(ended.code == 0, qPrintable(ended.error));
        const QStringList named = ended.output.split(u'\n', Qt::SkipEmptyParts);
        QVERIFY(named.size() >= 12);
        QStringList sizes;
        for (const QString& file : named) {
            const QImage picture(file);
            QVERIFY2(!picture.isNull(), qPrintable(file));
            sizes += u"%1x%2"_s.arg(picture.width()).arg(picture.height());
        }
        QVERIFY(sizes.contains(u"1440x900"_s) && sizes.contains(u"1024x700"_s));
        for (const QString& screen : {u"settings"_s, u"settings-edited"_s, u"review"_s, u"trend"_s,
                                      u"messages"_s, u"connect"_s, u"trend-dark"_s})
            QVERIFY2(ended.output.contains(u"-%1.png"_s.arg(screen)), qPrintable(screen));
    }

    void aFolderThatCannotBeMadeIsSaid()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(u"taken"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const Ended ended = run({u"--tour"_s, folder.filePath(u"taken/pictures"_s)});
        QCOMPARE(ended.code, 1);
        QVERIFY2(ended.error.contains(u"taken/pictures"_s), qPrintable(ended.error));
    }
};

QTEST_GUILESS_MAIN(StudioProgramFlow)
#include "flow_studio_program.moc"
