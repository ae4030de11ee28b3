#include "frames.h"
#include "message_export.h"
#include "message_text.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace lds::ui;
using lds::ports::FrameMeaning;

class MessageExportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void csvFieldsAreQuotedOnlyWhenTheyMustBe_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("escaped");
        QTest::newRow("plain") << QStringLiteral("read 400101") << QStringLiteral("read 400101");
        QTest::newRow("empty") << QString() << QString();
        QTest::newRow("comma") << QStringLiteral("a, b") << QStringLiteral("\"a, b\"");
        QTest::newRow("quote") << QStringLiteral("say \"no\"") << QStringLiteral("\"say \"\"no\"\"\"");
        QTest::newRow("line end") << QStringLiteral("a\nb") << QStringLiteral("\"a\nb\"");
        QTest::newRow("carriage return") << QStringLiteral("a\rb") << QStringLiteral("\"a\rb\"");
    }
    void csvFieldsAreQuotedOnlyWhenTheyMustBe()
    {
        QFETCH(QString, field);
        QFETCH(QString, escaped);
        QCOMPARE(csvLine({field, QStringLiteral("x"), field}), escaped + QStringLiteral(",x,") + escaped);
    }

    void copiedFieldsNeverBreakTheirLine()
    {
        QCOMPARE(tabLine({QStringLiteral("a\tb\r\nc"), QStringLiteral("d")}), QStringLiteral("a b  c\td"));
    }

    void aFileHasNamesAndOneLineForEachMessage()
    {
        const QByteArray file = messageFile({poll(), refused()}, MessageFileFormat::Csv);
        QVERIFY(file.startsWith("\xef\xbb\xbf"));
        const QString csv = QString::fromUtf8(file);
        const QStringList lines = csv.split(QStringLiteral("\r\n"));
        QCOMPARE(lines.size(), 4);
        QVERIFY(lines[0].contains(QStringLiteral("Time,Direction,Round trip (ms),Message,Bytes")));
        QVERIFY(lines[2].contains(QStringLiteral("received")));
        QVERIFY(lines[3].isEmpty());
        const QString text = QString::fromUtf8(messageFile({poll()}, MessageFileFormat::Text));
        QCOMPARE(text.count(QLatin1Char('\n')), 2);
        QCOMPARE(text.split(QLatin1Char('\n'))[1].count(QLatin1Char('\t')), messageFieldNames().size() - 1);
    }

    void theTimeOfASavedMessageIsUnambiguous()
    {
        const QDateTime time = QDateTime::fromString(messageFields(poll()).first(), Qt::ISODateWithMs);
        QVERIFY(time.isValid());
        QCOMPARE(time.toMSecsSinceEpoch(), 1'700'000'000'000);
    }

    void theNameDecidesTheFormat()
    {
        QVERIFY(formatOf(QStringLiteral("a.CSV")) == MessageFileFormat::Csv);
        QVERIFY(formatOf(QStringLiteral("a.txt")) == MessageFileFormat::Text);
        QVERIFY(formatOf(QStringLiteral("a")) == MessageFileFormat::Text);
    }

    void savingReplacesAFileAsAWholeAndTellsWhyItCannot()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("messages.csv"));
        QVERIFY(saveMessages(path, {poll()}).has_value());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), messageFile({poll()}, MessageFileFormat::Csv));
        const auto failed = saveMessages(folder.filePath(QStringLiteral("no/such/folder.csv")), {poll()});
        QVERIFY(!failed.has_value());
        QVERIFY(!failed.error().isEmpty());
    }
};

QTEST_GUILESS_MAIN(MessageExportTest)
#include "tst_message_export.moc"
