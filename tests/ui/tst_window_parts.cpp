#include "apply_summary.h"
#include "banner_area.h"
#include "command_texts.h"
#include "connection_form.h"
#include "fake_link.h"
#include "leave_question.h"
#include "manual_scheduler.h"
#include "recent_connections.h"
#include "review_table_model.h"
#include "session_notices.h"
#include "theme.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace lds;
using namespace lds::ui;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using support::settle;

/// The parts of the main window that need no window, on a sensor in memory.
class WindowPartsTest : public QObject {
    Q_OBJECT

    ports::ManualScheduler m_scheduler;
    std::unique_ptr<support::FakeLinkFactory> m_links;
    std::unique_ptr<sensor::SensorSession> m_session;
    ports::ConnectionUrl m_url;

    support::FakeSensor& device() { return m_links->sensor(m_url); }

    sensor::ApplyReport applied()
    {
        sensor::ApplyReport last;
        const auto connection = connect(m_session.get(), &sensor::SensorSession::applyFinished, this,
                                        [&last](const sensor::ApplyReport& report) { last = report; });
        m_session->apply();
        settle();
        disconnect(connection);
        return last;
    }

    static QLineEdit* field(ConnectionForm& form, const char* name)
    {
        return form.findChild<QLineEdit*>(QLatin1StringView(name));
    }
    static QString error(ConnectionForm& form, const char* name)
    {
        return form.findChild<QLabel*>(QLatin1StringView(name))->text();
    }

private Q_SLOTS:
    void init()
    {
        m_links = std::make_unique<support::FakeLinkFactory>(m_scheduler);
        m_url = {};
        m_url.host = u"sensor"_s;
        m_url.sensor = catalog::SensorModel::HlG203;
        m_session = std::make_unique<sensor::SensorSession>(m_url, *m_links, m_scheduler);
        m_session->open();
        settle();
        QVERIFY(m_session->isReady());
    }
    void cleanup() { m_session.reset(); }

    void theFormSaysWhatIsWrongBesideTheField_data()
    {
        QTest::addColumn<QString>("host");
        QTest::addColumn<QString>("port");
        QTest::addColumn<QByteArray>("wrong");
        QTest::newRow("no host") << QString() << u"502"_s << QByteArray("hostError");
        QTest::newRow("space in the host") << u"a b"_s << u"502"_s << QByteArray("hostError");
        QTest::newRow("other scheme") << u"http://sensor"_s << u"502"_s << QByteArray("hostError");
        QTest::newRow("no port") << u"sensor"_s << QString() << QByteArray("portError");
        QTest::newRow("port 0") << u"sensor"_s << u"0"_s << QByteArray("portError");
        QTest::newRow("port too large") << u"sensor"_s << u"65536"_s << QByteArray("portError");
        QTest::newRow("port is a word") << u"sensor"_s << u"modbus"_s << QByteArray("portError");
        QTest::newRow("all right") << u"sensor"_s << u"49152"_s << QByteArray();
    }
    void theFormSaysWhatIsWrongBesideTheField()
    {
        QFETCH(QString, host);
        QFETCH(QString, port);
        QFETCH(QByteArray, wrong);
        ConnectionForm form;
        field(form, "host")->setText(host);
        field(form, "port")->setText(port);
        QCOMPARE(form.check().has_value(), wrong.isEmpty());
        for (const char* label : {"hostError", "portError"})
            QCOMPARE(error(form, label).isEmpty(), wrong != label);
        QCOMPARE(field(form, "host")->text(), host); // nothing entered is lost
        QCOMPARE(field(form, "port")->text(), port);
    }

    void aWholeUrlInTheAddressFillsTheForm()
    {
        ConnectionForm form;
        field(form, "host")->setText(u"modbus-tcp://10.0.0.7:1502?sensor=HL-G208B-S-MK&view=only"_s);
        const auto url = form.check();
        QVERIFY(url);
        QCOMPARE(url->host, u"10.0.0.7"_s);
        QCOMPARE(url->port, 1502);
        QVERIFY(url->viewOnly);
        QCOMPARE(url->sensor, std::optional(catalog::SensorModel::HlG208));
    }

    void recentConnectionsAreNewestFirstEachOnceAndBounded()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"s.ini"_s);
        for (int round = 0; round < 2; ++round) {
            QSettings settings(file, QSettings::IniFormat);
            RecentConnections recent(settings);
            for (int n = 0; n < RecentConnections::most + 3; ++n) {
                ports::ConnectionUrl url;
                url.host = u"host%1"_s.arg(n);
                recent.add({url, u"name %1"_s.arg(n)});
            }
        }
        QSettings settings(file, QSettings::IniFormat);
        const auto list = RecentConnections(settings).list();
        QCOMPARE(list.size(), RecentConnections::most);
        QCOMPARE(list.first().url.host, u"host%1"_s.arg(RecentConnections::most + 2));
        QCOMPARE(list.first().name, u"name %1"_s.arg(RecentConnections::most + 2));
    }

    void recentConnectionsThatCannotBeReadAreLeftOut()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"s.ini"_s), QSettings::IniFormat);
        settings.beginWriteArray(u"connections/recent"_s);
        settings.setArrayIndex(0);
        settings.setValue(u"url"_s, u"ftp://x"_s);
        settings.setArrayIndex(1);
        settings.setValue(u"url"_s, u"modbus-tcp://good:502"_s);
        settings.endArray();
        const auto list = RecentConnections(settings).list();
        QCOMPARE(list.size(), 1);
        QCOMPARE(list.first().url.host, u"good"_s);
    }

    void theReviewShowsAnAddressAsOneRow()
    {
        m_session->edit({{ItemId::IpAddress1stOctet, 10}, {ItemId::IpAddress4thOctet, 77}});
        m_session->edit({{ItemId::OutputDelayTimerSetting, 5}});
        m_session->edit({{ItemId::HighSetValue, 17'500}});
        const ReviewTableModel model(*m_session);
        QCOMPARE(model.rowCount(), 3);
        const auto cell = [&](int row, int column) { return model.index(row, column).data().toString(); };
        QCOMPARE(cell(0, ReviewTableModel::Menu), u"31"_s); // as the sensor's menu has them
        QCOMPARE(cell(1, ReviewTableModel::Menu), u"422"_s);
        QCOMPARE(cell(2, ReviewTableModel::Menu), u"71"_s);
        QCOMPARE(cell(0, ReviewTableModel::Wanted), u"+1.7500"_s);
        QCOMPARE(cell(0, ReviewTableModel::Unit), u"mm"_s);
        QCOMPARE(cell(2, ReviewTableModel::Held), u"192.168.1.6"_s);
        QCOMPARE(cell(2, ReviewTableModel::Wanted), u"10.168.1.77"_s);
        QVERIFY(cell(2, ReviewTableModel::Note).contains(u"communication reset"_s));
    }

    void theReviewMarksAConflictWithWhatItWas()
    {
        m_session->edit({{ItemId::LowSetValue, -10'000}});
        device().set(ItemId::LowSetValue, -20'000);
        m_session->readAll();
        settle();
        const ReviewTableModel model(*m_session);
        QCOMPARE(model.rows().size(), 1);
        QVERIFY(model.rows().first().conflict);
        QVERIFY2(model.rows().first().note.contains(u"\u22125.0000"_s),
                 qPrintable(model.rows().first().note));
    }

    void aSummaryOfSuccessCountsAndHasNoSentences()
    {
        m_session->edit({{ItemId::AverageTimes, 3}, {ItemId::EcoMode, 0}});
        const auto summary = summarize(applied(), *m_session);
        QVERIFY2(summary.headline.startsWith(u"2 changes"_s), qPrintable(summary.headline));
        QVERIFY(summary.sentences.isEmpty());
    }

    void aRefusedWriteIsOneSentenceThatNamesIt()
    {
        m_session->edit({{ItemId::AverageTimes, 3}, {ItemId::EcoMode, 0}});
        device().refuse(ItemId::EcoMode);
        const auto summary = summarize(applied(), *m_session);
        QCOMPARE(summary.sentences.size(), 1);
        QVERIFY2(summary.sentences.first().startsWith(u"Eco mode"_s), qPrintable(summary.sentences.first()));
        QVERIFY2(summary.headline.startsWith(u"1 written, 1 not carried out"_s),
                 qPrintable(summary.headline));
    }

    void aValueThatReadsBackOtherwiseSaysBoth()
    {
        m_session->edit({{ItemId::HighSetValue, 17'500}});
        device().setJudge([](const settings::Values& state, const settings::Write& write) {
            settings::Values next = state;
            next.insert(write.first().item, 10'000);
            return support::FakeSensor::Verdict(next);
        });
        const auto summary = summarize(applied(), *m_session);
        QCOMPARE(summary.sentences.size(), 1);
        const QString sentence = summary.sentences.first();
        QVERIFY2(sentence.contains(u"+1.7500"_s) && sentence.contains(u"+1.0000"_s), qPrintable(sentence));
    }

    void whatTheSensorChangedByItselfIsSaid() // §4.3.4
    {
        device().set(ItemId::TriggerMode, 1);
        m_session->readAll();
        settle();
        m_session->edit({{ItemId::HoldMode, 1}});
        const auto summary = summarize(applied(), *m_session);
        QVERIFY2(summary.byTheWay.contains(u"Trigger mode"_s), qPrintable(summary.byTheWay));
    }

    void onlyWhatCannotBeUndoneAsks()
    {
        QList<ItemId> asking;
        for (const auto& item : catalog::Catalog::hlG2().items()) {
            if (needsQuestion(item.id))
                asking += item.id;
        }
        QCOMPARE(asking, (QList{ItemId::BankCopy, ItemId::SettingsInitialization,
                                ItemId::ResettingCommunicationSettings}));
        m_session->edit({{ItemId::AverageTimes, 3}});
        for (const ItemId item : asking) {
            const auto question = commandQuestion(item, 1, *m_session);
            QVERIFY(question.title.contains(m_session->name()) && !question.action.isEmpty());
            QVERIFY2(question.consequence.contains(u"not applied (1)"_s), qPrintable(question.consequence));
        }
        QVERIFY(commandQuestion(ItemId::ResettingCommunicationSettings, 0, *m_session)
                    .consequence.contains(u"192.168.1.6"_s));
    }

    void whyNothingCanBeWrittenNowIsSaid()
    {
        QVERIFY(whyNotNow(*m_session).isEmpty());
        device().refusePoll(ports::FailureCode::NotReady);
        settle();
        QVERIFY2(whyNotNow(*m_session).contains(u"menu"_s), qPrintable(whyNotNow(*m_session)));
        device().cut();
        settle();
        QVERIFY2(whyNotNow(*m_session).contains(u"not connected"_s), qPrintable(whyNotNow(*m_session)));
    }

    void leavingSaysForEachSensorWhatIsLost()
    {
        QVERIFY(lossesOf({m_session.get()}).isEmpty()); // "not known" is no loss of ours
        m_session->edit({{ItemId::AverageTimes, 3}});
        QVERIFY(lossesOf({m_session.get()}).first().contains(u"1 edit not applied"_s));
        applied();
        const QStringList losses = lossesOf({m_session.get()});
        QCOMPARE(losses.size(), 1);
        QVERIFY2(losses.first().startsWith(u"sensor: not saved"_s), qPrintable(losses.first()));
    }

    void aGraverMessageStandsAboveALighterOne()
    {
        BannerArea area;
        area.showMessage(u"i"_s, {Banner::Kind::Information, u"i"_s, {}, {}, true});
        area.showMessage(u"e"_s, {Banner::Kind::Error, u"e"_s, {}, {}, true});
        area.showMessage(u"w"_s, {Banner::Kind::Warning, u"w"_s, {}, {}, true});
        QStringList order;
        for (int index = 0; index < area.layout()->count(); ++index)
            order += static_cast<Banner*>(area.layout()->itemAt(index)->widget())->text();
        QCOMPARE(order, (QStringList{u"e"_s, u"w"_s, u"i"_s}));
        area.showMessage(u"e"_s, {Banner::Kind::Error, u"again"_s, {}, {}, true});
        QCOMPARE(area.layout()->count(), 3); // one line a subject
        QCOMPARE(area.find(u"e"_s)->text(), u"again"_s);
    }

    void anotherTypesValuesAreSaidUntilTheTypeIsRight()
    {
        BannerArea area;
        auto* notices = new SessionNotices(area);
        notices->setSession(m_session.get());
        QVERIFY(!area.find(u"model"_s));
        device().set(ItemId::HighSetValue, 200'000); // beyond the 30 mm type
        device().set(ItemId::DisplayDigit, 1);       // which starts at 0
        m_session->readAll();
        settle();
        QVERIFY(area.find(u"model"_s));
        m_session->setModel(catalog::SensorModel::HlG205);
        settle();
        QVERIFY(!area.find(u"model"_s));
    }

    void noticesEndWithTheirSession()
    {
        BannerArea area;
        auto* notices = new SessionNotices(area);
        notices->setSession(m_session.get());
        device().cut();
        settle();
        QVERIFY(area.find(u"connection"_s));
        notices->setSession(nullptr);
        QVERIFY(area.isEmpty());
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    Theme::instance().apply(application, ThemeMode::Light);
    ports::registerMetaTypes();
    WindowPartsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_window_parts.moc"
