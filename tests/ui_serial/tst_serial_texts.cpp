#include "serial_choices.h"
#include "serial_texts.h"

#include <QComboBox>
#include <QtTest>

using namespace lds;
using namespace lds::ui;
using namespace Qt::StringLiterals;
using ports::ScanFinding;
using ports::SerialParity;
using procedures::ChangeProblem;

class SerialTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void speedAndParityAreTheSensorsOwnWords()
    {
        QCOMPARE(serialText({38'400, SerialParity::Even}), u"38400 bps, EVEN + 1bit"_s);
        QCOMPARE(serialText({9'600, SerialParity::None}), u"9600 bps, NON + 2bit"_s);
        QCOMPARE(serialText({230'400, SerialParity::Odd}), u"230400 bps, ODD + 1bit"_s);
    }

    void theBoxesHoldEveryCombination()
    {
        QComboBox speeds;
        QComboBox parities;
        fillSpeeds(&speeds);
        fillParities(&parities);
        for (const ports::SerialSettings& each : ports::everySerialSettings()) {
            showSerial(each, &speeds, &parities);
            QCOMPARE(serialOf(&speeds, &parities), each);
        }
        QCOMPARE(speeds.count() * parities.count(), ports::everySerialSettings().size());
    }

    void aListOfAddressesIsRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QList<quint8>>("units");
        using L = QList<quint8>;
        QTest::newRow("one") << u"7"_s << L{7};
        QTest::newRow("spaces") << u" 7 "_s << L{7};
        QTest::newRow("a range and one") << u"1-4, 7"_s << L{1, 2, 3, 4, 7};
        QTest::newRow("en dash") << u"1\u20134"_s << L{1, 2, 3, 4};
        QTest::newRow("each once, in order") << u"9,2,9,1-2"_s << L{1, 2, 9};
        QTest::newRow("the last") << u"247"_s << L{247};
    }
    void aListOfAddressesIsRead()
    {
        QFETCH(QString, text);
        QFETCH(QList<quint8>, units);
        QCOMPARE(parseUnits(text), std::optional(units));
    }

    void whatIsNoAddressIsRefused_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text : {"", " ", "0", "248", "-1", "1-", "1-0", "4-1", "1,,2", "1-2-3", "a", "1.5",
                                 "+", "300", "1-248", "99999999999"})
            QTest::newRow(text) << QString::fromLatin1(text);
    }
    void whatIsNoAddressIsRefused()
    {
        QFETCH(QString, text);
        QVERIFY(!parseUnits(text));
    }

    void everyFindingHasAWordAndTroubleHasAdvice()
    {
        using Kind = ScanFinding::Kind;
        QStringList words;
        for (const Kind kind : {Kind::Sensor, Kind::OtherDevice, Kind::TwoUnits, Kind::Noise}) {
            const ScanFinding finding{kind, {}, 3};
            QVERIFY(!findingWord(finding).isEmpty() && !words.contains(findingWord(finding)));
            words.append(findingWord(finding));
            QCOMPARE(findingAdvice(finding).isEmpty(), kind == Kind::Sensor);
        }
    }

    void everyObstacleHasASentence()
    {
        for (const ChangeProblem problem :
             {ChangeProblem::NothingToChange, ChangeProblem::NotPossibleNow, ChangeProblem::OthersOnLine,
              ChangeProblem::AddressInList, ChangeProblem::AddressAnswers})
            QVERIFY(!obstacleSentence(problem, 7).isEmpty());
        QVERIFY(obstacleSentence(ChangeProblem::AddressInList, 7).contains(u'7'));
    }
};

QTEST_MAIN(SerialTextsTest)
#include "tst_serial_texts.moc"
