# Statement by statement of the manual (docs/conformance.md).
foreach(subject alarm banks hold judgment light network output_delay saving sensing system teaching
        zero_and_reset)
    lds_test(tst_manual_${subject} LABEL unit
        SOURCES tst_manual_${subject}.cpp sensor_fixture.h manual_items.h
        LINKS lds_emulator_sensor)
endforeach()
foreach(subject procedures registers)
    lds_test(tst_manual_modbus_${subject} LABEL unit
        SOURCES tst_manual_modbus_${subject}.cpp sensor_fixture.h manual_items.h
        LINKS lds_emulator_servers)
endforeach()
lds_test(tst_manual_modbus_messages LABEL unit LINKS lds_emulator_servers)
